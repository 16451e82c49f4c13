# Where results cannot be written, the program says so and fails; half a file is never left behind, and what stood there
# before still does. Programs whose data are not here are left out.
include(${CMAKE_CURRENT_LIST_DIR}/expect.cmake)

# Ways to have no room: a limit on the size of files acts like a full disk (without the signal of the limit the write
# itself fails), /dev/full is one, and below a file there is no folder, whatever the rights of the user.
find_program(BASH bash)
set(limited ${BASH} -c "trap '' XFSZ && ulimit -f 0 && exec \"$@\"" bash)
file(WRITE ${WORK_DIR}/file "")
set(below ${WORK_DIR}/file/out)

function(expect_nothing_left)
  file(GLOB left ${WORK_DIR}/*partial*)
  if(left)
    message(FATAL_ERROR "left behind by ${ARGN}: ${left}")
  endif()
endfunction()

# The command writes `name` first. It fails, and what stood there before still does.
function(expect_kept name)
  if(NOT BASH)
    return()
  endif()
  file(WRITE ${WORK_DIR}/${name} "kept")
  expect(1 "${name}: cannot be written" ${limited} ${ARGN})
  file(READ ${WORK_DIR}/${name} text)
  if(NOT text STREQUAL "kept")
    message(FATAL_ERROR "${name} was lost to ${ARGN}")
  endif()
  expect_nothing_left(${ARGN})
endfunction()

# The command writes `name`, which leads to a device without room. It fails, and the link stays.
function(expect_full name)
  if(NOT EXISTS /dev/full)
    return()
  endif()
  file(REMOVE ${WORK_DIR}/${name})
  file(CREATE_LINK /dev/full ${WORK_DIR}/${name} SYMBOLIC)
  expect(1 "${name}: cannot be written" ${ARGN})
  if(NOT IS_SYMLINK ${WORK_DIR}/${name})
    message(FATAL_ERROR "${name} is no link any more after ${ARGN}")
  endif()
  file(REMOVE ${WORK_DIR}/${name})
  expect_nothing_left(${ARGN})
endfunction()

function(expect_no_room)
  expect_kept(${ARGN})
  expect_full(${ARGN})
endfunction()

# What a program prints is a result, too.
function(expect_no_room_for_output)
  if(BASH AND EXISTS /dev/full)
    expect(1 "standard output: cannot be written" ${BASH} -c "\"$@\" >/dev/full" bash ${ARGN})
  endif()
endfunction()

file(GLOB files ${SAMPLES_DATA}/*.txt)
list(GET files 0 good)
set(omnidir ${SAMPLES_DATA}/omnidir)
set(pose ${PROGRAM} --repeat=1 --method=SQPNP)
set(full ${PROGRAM} --repeat=1 --method=GMLPNP_MARGINAL)

expect(1 "out.csv: cannot be written" ${pose} --csv=${below}.csv ${good})
expect(1 "out.csv: cannot be written" ${full} --residuals=${below}.csv ${good})
expect(1 "file" ${EXPERIMENTS} --trials=2 --out=${below} case)
if(EXISTS /dev/full)
  expect(1 "/dev/full: cannot be written" ${pose} --csv=/dev/full ${good})
endif()

expect_no_room(poses.csv ${pose} --csv=${WORK_DIR}/poses.csv ${good})
expect_no_room(residuals.csv ${full} --residuals=${WORK_DIR}/residuals.csv ${good})
expect_no_room(view.csv ${PROGRAMS}/omnidir_pose ${omnidir}/chessboard_camera.yml ${omnidir}/chessboard_09.txt
               --residuals=${WORK_DIR}/view.csv)
expect_no_room(case.csv ${EXPERIMENTS} --trials=2 --out=${WORK_DIR} case)
expect_no_room(reliability.csv ${RELIABILITY} --problems=1 --out=${WORK_DIR})
expect_full(failures.csv ${RELIABILITY} --problems=1 --out=${WORK_DIR})

foreach(name lidar_motion make_orthophoto omnidir_pose rgbd_correspondences rgbd_motion textured_object uav_localization)
  if(EXISTS ${PROGRAMS}/${name})
    expect_no_room_for_output(${PROGRAMS}/${name} --help)
  endif()
endforeach()
expect_no_room_for_output(${EXPERIMENTS} --help)
expect_no_room_for_output(${RELIABILITY} --help)
expect_no_room_for_output(${pose} ${good})
expect_no_room_for_output(${RELIABILITY} --problems=1)

# The object of textured_object as text: a video of two grey frames, in which nothing is found.
set(textured ${PROGRAMS}/textured_object)
if(EXISTS ${textured})
  set(object ${WORK_DIR}/object)
  string(REPEAT "0, " 31 zeros)
  file(WRITE ${object}/cookies_ORB.yml "%YAML:1.0\n---\n"
    "points_3d: !!opencv-matrix\n   rows: 1\n   cols: 1\n   dt: \"3f\"\n   data: [ 0., 0., 0. ]\n"
    "descriptors: !!opencv-matrix\n   rows: 1\n   cols: 32\n   dt: u\n   data: [ ${zeros}0 ]\n")
  file(WRITE ${object}/box.ply "ply\nformat ascii 1.0\nelement vertex 1\nend_header\n0 0 0\n")
  string(REPEAT "Z" 4608 grey) # 64 x 48, the colours at a quarter
  file(WRITE ${object}/box.mp4 "YUV4MPEG2 W64 H48 F30:1 C420jpeg\nFRAME\n${grey}FRAME\n${grey}")
  set(written --csv=${WORK_DIR}/track.csv --video=${WORK_DIR}/track.avi)
  expect(0 "0 poses in 2 frames" ${textured} ${object} ${written})
  expect_no_room(track.csv ${textured} ${object} --csv=${WORK_DIR}/track.csv --video=)
  expect_no_room(track.avi ${textured} ${object} --csv=/dev/null --video=${WORK_DIR}/track.avi)
  expect_no_room_for_output(${textured} ${object} --csv=/dev/null --video=)
endif()

set(data ${DATA_DEFAULT})
if(DEFINED ENV{GMLPNP_DATA})
  set(data $ENV{GMLPNP_DATA})
endif()
set(study --methods=SQPNP --output=${WORK_DIR})

set(tum ${data}/tum_fr1_rpy)
if(EXISTS ${tum}/groundtruth.txt)
  set(rgbd ${PROGRAMS}/rgbd_correspondences ${tum} ${WORK_DIR} --pairs=1 --name=pair)
  expect(0 "pair_" ${rgbd})
  file(GLOB pair RELATIVE ${WORK_DIR} ${WORK_DIR}/pair_*.txt)
  expect_no_room(${pair} ${rgbd})
  # Every file of those that a study writes, here for all programs that are one.
  set(motion ${PROGRAMS}/rgbd_motion ${tum} --interval=9.7 --ransac=0 ${study})
  expect_kept(table.md ${motion})
  foreach(name table.md errors.csv residuals.md residuals.csv)
    expect_full(${name} ${motion} --residuals)
  endforeach()
  expect_no_room_for_output(${motion})
endif()

set(kitti ${data}/kitti360)
if(EXISTS ${kitti}/pseudo_velo_motion.txt)
  expect_no_room(table.md ${PROGRAMS}/lidar_motion ${kitti} --motion=${kitti}/pseudo_velo_motion.txt --every=11
                 ${study})
endif()

set(ngi ${data}/aerial_ngi)
if(EXISTS ${PROGRAMS}/make_orthophoto AND EXISTS ${ngi}/ngi_xyz_opk.csv)
  set(first 3324c_2015_1004_05_0182_RGB)
  set(second 3324c_2015_1004_05_0184_RGB)
  set(map --dem=${ngi}/dem.tif --poses=${ngi}/ngi_xyz_opk.csv "--camera=833.333333 833.333333 319.5 575.5")
  set(ortho ${PROGRAMS}/make_orthophoto ${ngi}/${second}.tif)
  expect(1 "out.tif: cannot be written" ${ortho} ${below}.tif ${map})
  expect_no_room(ortho.tif ${ortho} ${WORK_DIR}/ortho.tif ${map})
  set(localized ${PROGRAMS}/uav_localization ${ngi}/${second}.tif --reference=${ngi}/${first}.tif ${map} --features=4000
                ${study})
  expect_no_room(map_${second}_by_${first}.asc ${localized})
  expect_full(map_${second}_by_${first}.csv ${localized})
  expect_full(positions.csv ${localized})
endif()
