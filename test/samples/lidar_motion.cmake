# The KITTI-360 frames among the data, through their own lens and resampled into the fisheye that looks aside.
include(${CMAKE_CURRENT_LIST_DIR}/expect.cmake)
require_data(kitti360/pseudo_velo_motion.txt)

set(root ${DATA}/kitti360)
set(options --motion=${root}/pseudo_velo_motion.txt --methods=SQPNP,GMLPNP_MARGINAL)
set(number "[0-9.]+ \\[[-0-9., ]+\\] \\| +[0-9.]+ \\| +")

# One frame apart, about 1 m: the truth is good for 1 to 3 cm.
expect(0 "12 pairs, 0 without.*SQPNP +\\| +12 \\| +0 \\| +0\\.0[0-9]+ .*GMLPNP_MARGINAL \\| +12 \\| +0 \\| +0\\.0${number}[12]\\.[0-9]+ \\[.*with pairs"
       ${PROGRAM} ${root} ${options} --step=1 --residuals --output=${WORK_DIR}/out)
foreach(name table.md errors.csv residuals.md residuals.csv)
  if(NOT EXISTS ${WORK_DIR}/out/${name})
    message(FATAL_ERROR "no ${name}")
  endif()
endforeach()
expect_drawn(${WORK_DIR}/out errors.png residuals.png)

# Three frames apart, from picture to picture.
expect(0 "3 frames apart: 3 pairs, 0 without correspondences; [1-9][0-9][0-9] points" ${PROGRAM} ${root} ${options}
       --step=3 --every=4 --chain)

# Through the fisheye, with points beyond 90 degrees: only this module solves there, and as well.
expect(0 "camera 00 through 03.*SQPNP +\\| +0 \\| +3 \\|.*GMLPNP_MARGINAL \\| +3 \\| +0 \\| +0\\.[01]${number}[0-2]\\.[0-9]+ \\["
       ${PROGRAM} ${root} 2013_05_28_drive_0003_sync ${options} --step=1 --every=4 --through=03 --aside=60 --field=240)
