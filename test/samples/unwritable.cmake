# Where results cannot be written, the program says so and fails; half a file is never left behind. The parent of an
# unwritable path is a file, which no rights of the user change.
include(${CMAKE_CURRENT_LIST_DIR}/expect.cmake)

file(GLOB files ${SAMPLES_DATA}/*.txt)
list(GET files 0 good)
file(WRITE ${WORK_DIR}/file "")
set(below ${WORK_DIR}/file/out)
set(pose ${PROGRAM} --repeat=1 --method=SQPNP)

expect(1 "out.csv: cannot be written" ${pose} --csv=${below}.csv ${good})
expect(1 "out.png: cannot be written" ${PROGRAM} --repeat=1 --method=GMLPNP_MARGINAL --picture=${below}.png ${good})
expect(1 "file" ${EXPERIMENTS} --trials=2 --out=${below} case)
set(data ${DATA_DEFAULT})
if(DEFINED ENV{GMLPNP_DATA})
  set(data $ENV{GMLPNP_DATA})
endif()
set(ngi ${data}/aerial_ngi)
if(MAKE_ORTHOPHOTO AND EXISTS ${ngi}/ngi_xyz_opk.csv)
  expect(1 "out.tif: cannot be written" ${MAKE_ORTHOPHOTO} ${ngi}/3324c_2015_1004_05_0184_RGB.tif ${below}.tif
         --dem=${ngi}/dem.tif --poses=${ngi}/ngi_xyz_opk.csv "--camera=833.333333 833.333333 319.5 575.5")
endif()
if(EXISTS /dev/full)
  expect(1 "/dev/full: cannot be written" ${pose} --csv=/dev/full ${good})
  file(CREATE_LINK /dev/full ${WORK_DIR}/case.csv SYMBOLIC)
  expect(1 "case.csv: cannot be written" ${EXPERIMENTS} --trials=2 --out=${WORK_DIR} case)
endif()

# Nothing is left over, and an earlier result stays.
file(WRITE ${WORK_DIR}/kept.csv "kept")
expect(0 "SQPNP" ${pose} --csv=${WORK_DIR}/kept.csv ${good})
file(GLOB left ${WORK_DIR}/*partial*)
if(left)
  message(FATAL_ERROR "left behind: ${left}")
endif()
