# SPDX-License-Identifier: Apache-2.0
# run(COMMAND ARG...): runs a command of a test script; the script fails with it.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if(result)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "failed: ${command}")
  endif()
endfunction()
