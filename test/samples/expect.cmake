# Runs a program and checks its exit code and that its output (both streams) matches a regular expression.

function(expect code pattern)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result STREQUAL code)
    message(FATAL_ERROR "exit code ${result}, expected ${code}: ${ARGN}\n${output}")
  endif()
  if(NOT output MATCHES "${pattern}")
    message(FATAL_ERROR "'${pattern}' is not in the output of ${ARGN}\n${output}")
  endif()
endfunction()

# Two files that runs with another number of threads must write alike.
function(expect_same one other)
  file(READ ${one} first)
  file(READ ${other} second)
  if(NOT first STREQUAL second)
    message(FATAL_ERROR "${one} and ${other} differ: the number of threads matters")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
file(MAKE_DIRECTORY ${WORK_DIR})

# Ends the test, which counts as skipped, where a file of the data sets is not there.
macro(require_data name)
  if(DEFINED ENV{GMLPNP_DATA})
    set(DATA $ENV{GMLPNP_DATA})
  else()
    set(DATA ${DATA_DEFAULT})
  endif()
  if(NOT EXISTS ${DATA}/${name})
    message("skipped: no ${name} in ${DATA}; its folder is GMLPNP_DATA")
    return()
  endif()
endmacro()
