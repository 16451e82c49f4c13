# The committed view of a catadioptric camera: a pose, its noise and its residuals; unusable files: exit code 1 and a message.
include(${CMAKE_CURRENT_LIST_DIR}/expect.cmake)

set(camera ${SAMPLES_DATA}/omnidir/chessboard_camera.yml)
set(points ${SAMPLES_DATA}/omnidir/chessboard_09.txt)

# The calibration's own rms of this view is 0.977 px.
expect(0 "54 points, 0 without a ray; up to 1[0-9][0-9]\\.[0-9] degrees.*root mean square: 0\\.9[78].*Sigma.*Gamma"
       ${PROGRAM} ${camera} ${points} --residuals=${WORK_DIR}/residuals.csv)
file(STRINGS ${WORK_DIR}/residuals.csv rows REGEX "^[0-9]")
list(LENGTH rows count)
if(NOT count EQUAL 54)
  message(FATAL_ERROR "${count} rows in residuals.csv, expected 54")
endif()
expect_drawn(${WORK_DIR}/residuals.csv)
expect(0 "Gamma in the picture, mean over the pixels: standard deviations 0\\.[0-9]+ px.*1 mrad is 0\\.[0-9]+ px"
       ${PROGRAM} ${camera} ${points})
expect(0 "GMLPNP also gives" ${PROGRAM} ${camera} ${points} --method=GMLPNP)

# A correspondence file that has a camera of its own needs the calibration file all the same, and any lens will do.
file(WRITE ${WORK_DIR}/panorama.yml "%YAML:1.0\n---\ncamera:\n   model: equirectangular\n   width: 1280\n   height: 960\n")
expect(0 "54 points, 0 without a ray" ${PROGRAM} ${WORK_DIR}/panorama.yml ${points})

expect(0 "Usage" ${PROGRAM} --help)
expect(2 "Usage" ${PROGRAM} ${camera})
expect(1 "one correspondence file" ${PROGRAM} ${camera} ${points} ${points})
expect(2 "unknown option --modle=fisheye" ${PROGRAM} ${camera} ${points} --modle=fisheye)
expect(1 "'EPNP' is neither" ${PROGRAM} ${camera} ${points} --method=EPNP)
expect(1 "nowhere.yml: cannot be opened" ${PROGRAM} ${WORK_DIR}/nowhere.yml ${points})
expect(1 "nowhere.txt: cannot be opened" ${PROGRAM} ${camera} ${WORK_DIR}/nowhere.txt)
file(WRITE ${WORK_DIR}/bad.yml "%YAML:1.0\n---\nK: [1, 0, 0]\n")
expect(1 "bad.yml: camera field" ${PROGRAM} ${WORK_DIR}/bad.yml ${points})
file(WRITE ${WORK_DIR}/few.txt "0 0 0 600 400\n1 0 0 700 400\n0 1 0 600 500\n")
expect(1 "few.txt:3: the file ends after 3 points" ${PROGRAM} ${camera} ${WORK_DIR}/few.txt)
file(WRITE ${WORK_DIR}/line.txt "0 0 0 600 400\n1 0 0 610 400\n2 0 0 620 400\n3 0 0 630 400\n4 0 0 640 400\n")
expect(1 "line.txt: no pose by GMLPNP_MARGINAL" ${PROGRAM} ${camera} ${WORK_DIR}/line.txt)
expect(1 "cannot be written" ${PROGRAM} ${camera} ${points} --residuals=${WORK_DIR}/missing/residuals.csv)
