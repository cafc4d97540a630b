# SPDX-License-Identifier: Apache-2.0
# The page that reports are put into: web/, built by node in the build folder and read into the library by
# src/report/page.cpp. Without node and npm everything else is built, and reports say what is missing.
find_program(JPRIM_NODE NAMES node nodejs DOC "node, which builds the page of reports")
find_program(JPRIM_NPM npm DOC "npm, which fetches what the page of reports is made of")
mark_as_advanced(JPRIM_NODE JPRIM_NPM)
set(web ${PROJECT_SOURCE_DIR}/web)
if(JPRIM_BUILD_REPORT_PAGE AND JPRIM_NODE AND JPRIM_NPM AND EXISTS ${web}/build.mjs)
  set(page ${PROJECT_BINARY_DIR}/report/report.html)
  file(GLOB_RECURSE web_sources CONFIGURE_DEPENDS ${web}/src/* ${web}/build.mjs ${web}/package*.json)
  add_custom_command(OUTPUT ${page}
    COMMAND ${CMAKE_COMMAND} -D NODE=${JPRIM_NODE} -D NPM=${JPRIM_NPM} -D WEB=${web} -D PAGE=${page}
      -D WORK=${PROJECT_BINARY_DIR}/web -P ${CMAKE_CURRENT_LIST_DIR}/build_report_page.cmake
    DEPENDS ${web_sources} ${CMAKE_CURRENT_LIST_DIR}/build_report_page.cmake
    COMMENT "Building the page of reports")
  set_source_files_properties(report/page.cpp PROPERTIES
    COMPILE_DEFINITIONS JPRIM_REPORT_PAGE="${page}" OBJECT_DEPENDS ${page})
elseif(JPRIM_BUILD_REPORT_PAGE)
  message(STATUS "No node or npm (Debian: nodejs, npm): jprim is built without reports")
endif()
