# SPDX-License-Identifier: Apache-2.0
# Runs a model, and opens its report in a browser.
if(NOT NODE)
  message(STATUS "skipped: there is no node (Debian: nodejs)")
  return()
endif()
file(MAKE_DIRECTORY ${WORK})
execute_process(COMMAND ${TOOL} run ${MODEL} --end ${END} --steps 200 --out ${WORK}/results --report ${WORK}/report.html
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE error)
if(error MATCHES "built without reports")
  message(STATUS "skipped: jprim was built without reports")
  return()
endif()
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${output}${error}")
endif()
execute_process(COMMAND ${NODE} ${CMAKE_CURRENT_LIST_DIR}/browser.mjs ${WORK}/report.html ${WORK}/results ${MODULES}
  ${WORK}/report.png RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "The report is not what it should be")
endif()
