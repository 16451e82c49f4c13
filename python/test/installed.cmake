# Installs the build into an empty prefix and imports the package from there, with the library found by its run path.
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
file(MAKE_DIRECTORY ${WORK_DIR})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --config "${CONFIG}" --prefix ${WORK_DIR}/prefix)
set(ENV{PYTHONPATH} ${WORK_DIR}/prefix/${INSTALL_DIR})
run(
  ${CMAKE_COMMAND} -E chdir ${WORK_DIR} ${PYTHON} -c "import gmlpnp
assert gmlpnp.__file__.startswith('${WORK_DIR}/prefix'), gmlpnp.__file__
retval, result = gmlpnp.solveRays([[0, 0, 3], [1, 0, 3], [0, 1, 4], [1, 1, 5], [-1, 0, 4], [0, -1, 3]],
                                  [[0, 0, 3], [1, 0, 3], [0, 1, 4], [1, 1, 5], [-1, 0, 4], [0, -1, 3]])
assert retval and abs(result.tvec).max() < 1e-6, result
import os
package = os.path.dirname(gmlpnp.__file__)
files = {'__init__.pyi', 'fisheye.pyi', 'py.typed'}
assert files <= set(os.listdir(package)), os.listdir(package)
maps = '/proc/self/maps'  # Linux only
libraries = [line.split()[-1] for line in open(maps) if 'opencv_gmlpnp' in line] if os.path.exists(maps) else []
assert all(library.startswith('${WORK_DIR}/prefix') for library in libraries), libraries
print(gmlpnp.__version__, result)")
