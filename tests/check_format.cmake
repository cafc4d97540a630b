# SPDX-License-Identifier: Apache-2.0
# Fails, and names the places, if CLANG_FORMAT would change one of the sources in SOURCE.
foreach(folder include src tests examples benchmarks)
  file(GLOB_RECURSE files ${SOURCE}/${folder}/*.cpp ${SOURCE}/${folder}/*.h)
  execute_process(COMMAND ${CLANG_FORMAT} --dry-run -Werror ${files} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "Run clang-format -i on the files named above")
  endif()
endforeach()
