# The program: a table, its files, the same for any number of threads; then wrong usage.
include(${CMAKE_CURRENT_LIST_DIR}/../samples/expect.cmake)

expect(0 "--searched" ${PROGRAM} --help)
expect(0 "solveRays, GMLPNP_MARGINAL.*cv::solvePnP, SQPNP" ${PROGRAM} --problems=200 --searched=50 --starts=5 --threads=1
       --out=${WORK_DIR}/one)
expect(0 "solvePnP, GMLPNP" ${PROGRAM} --problems=200 --searched=50 --starts=5 --threads=3 --out=${WORK_DIR}/three)
foreach(name reliability failures)
  expect_same(${WORK_DIR}/one/${name}.csv ${WORK_DIR}/three/${name}.csv)
endforeach()

expect(2 "unknown option --problem=5" ${PROGRAM} --problem=5)
expect(1 "--problems must be at least 1" ${PROGRAM} --problems=0)
expect(1 "--searched" ${PROGRAM} --problems=1 --searched=-1)
expect(1 "--threads" ${PROGRAM} --problems=1 --threads=-1)
file(WRITE ${WORK_DIR}/file "")
expect(1 "file" ${PROGRAM} --problems=1 --out=${WORK_DIR}/file/out)
