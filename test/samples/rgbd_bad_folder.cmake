# Folders that are no usable sequence: exit code 1 and a message that names the file.
include(${CMAKE_CURRENT_LIST_DIR}/expect.cmake)

expect(0 "Usage" ${PROGRAM} --help)
expect(2 "Usage" ${PROGRAM} ${WORK_DIR})
expect(1 "groundtruth.txt: cannot be opened" ${PROGRAM} ${WORK_DIR} ${WORK_DIR})

file(WRITE ${WORK_DIR}/groundtruth.txt "# a comment\n1.00 0 0 0 0 0 0 1\n1.05 0 0 0 0 0 0 1\n1.12 0 0 0 0 0 0 1\n")
file(WRITE ${WORK_DIR}/rgb.txt "1.01 rgb/1.01.png\n1.11 rgb/1.11.png\n")
expect(1 "depth.txt: cannot be opened" ${PROGRAM} ${WORK_DIR} ${WORK_DIR})
file(WRITE ${WORK_DIR}/depth.txt "1.01 depth/1.01.png\nlate\n")
expect(1 "depth.txt:2: not understood" ${PROGRAM} ${WORK_DIR} ${WORK_DIR})
file(WRITE ${WORK_DIR}/depth.txt "1.01 depth/1.01.png\n1.11 depth/1.11.png\n")
expect(1 "rgb/1.01.png: cannot be read as an image" ${PROGRAM} ${WORK_DIR} ${WORK_DIR})
expect(1 "no two frames" ${PROGRAM} ${WORK_DIR} ${WORK_DIR} --interval=5)
expect(1 "--camera" ${PROGRAM} ${WORK_DIR} ${WORK_DIR} "--camera=500 500 320")
expect(1 "--distortion" ${PROGRAM} ${WORK_DIR} ${WORK_DIR} "--distortion=a b c d")
expect(1 "--pairs" ${PROGRAM} ${WORK_DIR} ${WORK_DIR} --pairs=-1)
