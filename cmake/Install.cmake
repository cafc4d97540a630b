# SPDX-License-Identifier: Apache-2.0
include(CMakePackageConfigHelpers)

install(TARGETS jprim EXPORT jprim-targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
if(JPRIM_BUILD_TOOL)
  install(TARGETS jprim_tool RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/jprim DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES ${PROJECT_BINARY_DIR}/include/jprim/version.h
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/jprim)

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/jprim)
install(EXPORT jprim-targets NAMESPACE jprim:: DESTINATION ${config_dir})
configure_package_config_file(cmake/jprim-config.cmake.in ${PROJECT_BINARY_DIR}/jprim-config.cmake
  INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/jprim-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/jprim-config.cmake ${PROJECT_BINARY_DIR}/jprim-config-version.cmake
  DESTINATION ${config_dir})
