# SPDX-License-Identifier: Apache-2.0
# Builds the page in a copy of web/. npm needs the network the first time; without it the page is left empty, which the
# next build tries again.
get_filename_component(folder ${PAGE} DIRECTORY)
file(MAKE_DIRECTORY ${folder} ${WORK})
file(COPY ${WEB}/ DESTINATION ${WORK} PATTERN node_modules EXCLUDE PATTERN dist EXCLUDE)

function(give_up reason)
  message(WARNING "${reason}: jprim is built without reports")
  file(WRITE ${PAGE} "")
  execute_process(COMMAND touch -d @1 ${PAGE})
  return()
endfunction()

set(installed ${WORK}/node_modules/.installed)
if(NOT EXISTS ${installed} OR ${WEB}/package-lock.json IS_NEWER_THAN ${installed})
  execute_process(COMMAND ${NPM} ci --no-audit --no-fund --loglevel=error --fetch-retries=0 --fetch-timeout=20000
    WORKING_DIRECTORY ${WORK} TIMEOUT 240 RESULT_VARIABLE result ERROR_VARIABLE error)
  if(NOT result EQUAL 0)
    give_up("npm cannot fetch what the page of reports is made of (${result}) ${error}")
    return()
  endif()
  file(TOUCH ${installed})
endif()
execute_process(COMMAND ${NODE} build.mjs --out ${folder} WORKING_DIRECTORY ${WORK} TIMEOUT 240
  RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  file(REMOVE ${PAGE})
  message(FATAL_ERROR "The page of reports cannot be built")
endif()
