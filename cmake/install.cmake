# The installed package: find_package(gmlpnp) gives gmlpnp::gmlpnp, pkg-config knows `gmlpnp`.

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
find_package(OpenCV REQUIRED COMPONENTS core) # the module has found it, but for its own directory only

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/gmlpnp)

install(TARGETS ${libraries} EXPORT gmlpnpTargets
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY modules/gmlpnp/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(EXPORT gmlpnpTargets NAMESPACE gmlpnp:: DESTINATION ${package_dir})

# The module that holds cv::solvePnP is the one the library was linked with: opencv_calib3d or opencv_geometry.
get_target_property(OPENCV_COMPONENTS opencv_gmlpnp INTERFACE_LINK_LIBRARIES)
list(FILTER OPENCV_COMPONENTS INCLUDE REGEX "^opencv_")
list(TRANSFORM OPENCV_COMPONENTS REPLACE "^opencv_" "")
list(JOIN OPENCV_COMPONENTS " " OPENCV_COMPONENTS)

configure_package_config_file(cmake/gmlpnpConfig.cmake.in gmlpnpConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(gmlpnpConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/gmlpnpConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/gmlpnpConfigVersion.cmake
        DESTINATION ${package_dir})

# OpenCV's own .pc file is optional in its build (and names every module), so ours says where OpenCV is.
list(TRANSFORM OpenCV_INCLUDE_DIRS PREPEND "-I" OUTPUT_VARIABLE PC_OPENCV_CFLAGS)
list(JOIN PC_OPENCV_CFLAGS " " PC_OPENCV_CFLAGS)
if(TARGET opencv_world)
  set(PC_OPENCV_LIBS "-L$<TARGET_FILE_DIR:opencv_world> -lopencv_world")
else()
  string(REGEX REPLACE "([^ ]+)" "-lopencv_\\1" PC_OPENCV_LIBS "${OPENCV_COMPONENTS}")
  set(PC_OPENCV_LIBS "-L$<TARGET_FILE_DIR:opencv_core> ${PC_OPENCV_LIBS}")
endif()
# The prefix is relative to the .pc file: an installation that was moved, or staged by `cmake --install --prefix`,
# still works.
file(RELATIVE_PATH PC_PREFIX "/prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/prefix")
string(REGEX REPLACE "/$" "" PC_PREFIX ${PC_PREFIX})
configure_file(cmake/gmlpnp.pc.in gmlpnp.pc.in @ONLY)
file(GENERATE OUTPUT gmlpnp.pc INPUT ${CMAKE_CURRENT_BINARY_DIR}/gmlpnp.pc.in)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/gmlpnp.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
