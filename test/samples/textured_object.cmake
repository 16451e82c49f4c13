# What it says of wrong usage and unusable data; with OpenCV's sources its data, too: a pose in every frame.
include(${CMAKE_CURRENT_LIST_DIR}/expect.cmake)

expect(0 "Usage" ${PROGRAM} --help)
expect(2 "Usage" ${PROGRAM})
expect(2 "unknown option --frame=1" ${PROGRAM} ${WORK_DIR} --frame=1)
expect(1 "cookies_ORB.yml: cannot be opened" ${PROGRAM} ${WORK_DIR}/nowhere)

set(data ${OPENCV_SOURCE}/samples/cpp/tutorial_code/calib3d/real_time_pose_estimation/Data)
if(NOT EXISTS ${data}/box.mp4)
  message(STATUS "The video was not found (GMLPNP_OPENCV_SOURCE): that half of the test is left out")
  return()
endif()
expect(0 "20 poses in 20 frames" ${PROGRAM} ${data} --frames=20 --csv=${WORK_DIR}/poses.csv
       --video=${WORK_DIR}/drawn.avi --picture=${WORK_DIR}/last.png)
file(STRINGS ${WORK_DIR}/poses.csv rows)
list(LENGTH rows count)
if(NOT count EQUAL 21 OR NOT EXISTS ${WORK_DIR}/drawn.avi OR NOT EXISTS ${WORK_DIR}/last.png)
  message(FATAL_ERROR "${count} rows in the CSV file, or no video or picture")
endif()
expect(1 "cannot be written" ${PROGRAM} ${data} --frames=1 --csv=${WORK_DIR}/missing/poses.csv)
