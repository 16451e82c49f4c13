# Target `doc`: HTML of the public headers and the tutorial. Not part of `all`; any warning fails it, and the test of the same name.

find_package(Doxygen QUIET)
if(NOT DOXYGEN_FOUND)
  return()
endif()

set(GMLPNP_DOC_DIR ${CMAKE_CURRENT_BINARY_DIR}/doc)
file(MAKE_DIRECTORY ${GMLPNP_DOC_DIR})
configure_file(${PROJECT_SOURCE_DIR}/doc/Doxyfile.in ${GMLPNP_DOC_DIR}/Doxyfile @ONLY)
add_custom_target(
  doc
  COMMAND ${DOXYGEN_EXECUTABLE} ${GMLPNP_DOC_DIR}/Doxyfile
  COMMENT "Documentation: ${GMLPNP_DOC_DIR}/html/index.html"
  VERBATIM)

if(GMLPNP_BUILD_TESTS)
  add_test(NAME doc COMMAND ${DOXYGEN_EXECUTABLE} ${GMLPNP_DOC_DIR}/Doxyfile)
endif()
