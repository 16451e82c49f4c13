# What cannot be used: exit code 1 and a message that says what; pictures without matches fail their pairs only.
include(${CMAKE_CURRENT_LIST_DIR}/expect.cmake)

expect(0 "Usage" ${PROGRAM} --help)
expect(2 "Usage" ${PROGRAM})
expect(2 "unknown option --out=x" ${PROGRAM} ${WORK_DIR} --out=x)
expect(1 "groundtruth.txt: cannot be opened" ${PROGRAM} ${WORK_DIR}/nowhere)

# Two grey pictures without a feature, in the benchmark's layout; the name tells the camera.
set(sequence ${WORK_DIR}/rgbd_dataset_freiburg2_grey)
string(REPEAT "90 " 4096 grey)
file(WRITE ${sequence}/rgb/1.pgm "P2\n64 64\n255\n${grey}\n")
file(WRITE ${sequence}/depth/1.pgm "P2\n64 64\n65535\n${grey}\n")
file(WRITE ${sequence}/rgb.txt "1.01 rgb/1.pgm\n1.11 rgb/1.pgm\n")
file(WRITE ${sequence}/depth.txt "1.01 depth/1.pgm\n1.11 depth/1.pgm\n")
file(WRITE ${sequence}/groundtruth.txt "1.00 0 0 0 0 0 0 1\n1.05 0 0 0 0 0 0 1\n1.12 0 0 0 0 0 0 1\n")
expect(1 "1 pairs, 1 without correspondences.*Failed: rgbd_dataset_freiburg2_grey_1\\.010000: only 0 matches.*none of 1 pairs"
       ${PROGRAM} ${sequence} --residuals --output=${WORK_DIR}/out)
expect(1 "no two frames" ${PROGRAM} ${sequence} --interval=5)
expect(1 "--interval must be positive" ${PROGRAM} ${sequence} --interval=0)
expect(1 "unknown method 'DLT'" ${PROGRAM} ${sequence} --methods=SQPNP,DLT)
expect(1 "--repeat" ${PROGRAM} ${sequence} --repeat=0)
expect(1 "--camera: expected fx fy cx cy" ${PROGRAM} ${sequence} "--camera=500 500")
expect(1 "--camera: '500 x' is not a list" ${PROGRAM} ${sequence} "--camera=500 x")
expect(1 "cannot be made a folder" ${PROGRAM} ${sequence} --output=${sequence}/rgb.txt)

file(COPY ${sequence}/ DESTINATION ${WORK_DIR}/other)
expect(1 "other: the name tells no camera" ${PROGRAM} ${WORK_DIR}/other)
expect(1 "2 pairs, 2 without" ${PROGRAM} ${sequence} ${WORK_DIR}/other "--camera=500 500 32 32")

file(WRITE ${sequence}/depth/1.pgm "P2\n64 64\n255\n${grey}\n")
expect(1 "depth/1.pgm: a depth image has one channel of 16 bits" ${PROGRAM} ${sequence})
file(WRITE ${sequence}/rgb/1.pgm "nothing")
expect(1 "rgb/1.pgm: cannot be read as an image" ${PROGRAM} ${sequence})
