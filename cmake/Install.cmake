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
install(FILES ${PROJECT_BINARY_DIR}/include/jprim/version.h ${PROJECT_BINARY_DIR}/include/jprim/simbody_abi.h
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/jprim)

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/jprim)
install(EXPORT jprim-targets NAMESPACE jprim:: DESTINATION ${config_dir})
configure_package_config_file(cmake/jprim-config.cmake.in ${PROJECT_BINARY_DIR}/jprim-config.cmake
  INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/jprim-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/jprim-config.cmake ${PROJECT_BINARY_DIR}/jprim-config-version.cmake
  ${CMAKE_CURRENT_LIST_DIR}/Metis.cmake DESTINATION ${config_dir})

# For pkg-config. Simbody's own file asks for C++11, so what it says is said here.
file(RELATIVE_PATH JPRIM_PC_TO_PREFIX ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" JPRIM_PC_TO_PREFIX "${JPRIM_PC_TO_PREFIX}")
get_target_property(type jprim TYPE)
set(JPRIM_PC_STATIC_LIBS "")
if(type STREQUAL "STATIC_LIBRARY")
  get_filename_component(metis_dir ${JPRIM_METIS_LIBRARY} DIRECTORY)
  get_filename_component(metis_file ${JPRIM_METIS_LIBRARY} NAME)
  set(JPRIM_PC_STATIC_LIBS "-L${metis_dir} -l:${metis_file}")
endif()
configure_file(cmake/jprim.pc.in ${PROJECT_BINARY_DIR}/jprim.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/jprim.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
