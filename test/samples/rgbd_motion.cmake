# The TUM sequence among the data: every pair is matched and solved, and the errors are what they were measured to be.
include(${CMAKE_CURRENT_LIST_DIR}/expect.cmake)
require_data(tum_fr1_rpy/groundtruth.txt)

set(out ${WORK_DIR}/out)
expect(0 "99 pairs, 0 without correspondences.*Test of isotropy: distance 0\\.1[0-9]* of the trace; p = 0\\.000"
       ${PROGRAM} ${DATA}/tum_fr1_rpy --methods=EPNP,SQPNP,GMLPNP_MARGINAL --residuals --output=${out})
foreach(name table.md errors.csv residuals.md residuals.csv)
  if(NOT EXISTS ${out}/${name})
    message(FATAL_ERROR "no ${name}")
  endif()
endforeach()
expect_drawn(${out} errors.png residuals.png)

# Motion capture and rolling shutter leave about half a degree, whatever the method; the positions tell them apart.
file(READ ${out}/table.md table)
foreach(method SQPNP GMLPNP_MARGINAL)
  if(NOT table MATCHES "\\| ${method} +\\| +99 \\| +0 \\| +0\\.5[0-9]+ \\[[0-9., ]+\\] \\| +0\\.[345][0-9]+ \\| +(0\\.9|1\\.0)[0-9]+ ")
    message(FATAL_ERROR "the errors of ${method} are not those measured:\n${table}")
  endif()
endforeach()
# Negative, interval and all: the marginal estimator's positions are better than EPNP's and SQPNP's.
foreach(method EPNP SQPNP)
  if(NOT table MATCHES "\\| ${method} +\\| +99 \\|[^|]+\\|[^|]+\\| +-0\\.[0-9]+ \\[-0\\.[0-9]+, -0\\.[0-9]+\\]")
    message(FATAL_ERROR "no better than ${method}:\n${table}")
  endif()
endforeach()
