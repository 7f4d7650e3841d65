# SPDX-License-Identifier: MIT
# Install rules: library, headers, the package for find_package(stadimeter) and the .pc file.
include(CMakePackageConfigHelpers)
install(TARGETS stadimeter EXPORT stadimeter-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY lib/include/stad DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT stadimeter-targets NAMESPACE stadimeter:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/stadimeter)
configure_package_config_file(cmake/stadimeter-config.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/stadimeter-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/stadimeter)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/stadimeter-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/stadimeter-config.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/stadimeter-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/stadimeter)
# From the folder of the .pc file to the prefix, so that an install can go elsewhere than it was configured for.
file(RELATIVE_PATH STAD_PC_TO_PREFIX "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
configure_file(cmake/stadimeter.pc.in ${CMAKE_CURRENT_BINARY_DIR}/stadimeter.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/stadimeter.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
