# SPDX-License-Identifier: Apache-2.0
# Runs clang-tidy on the sources of the rooms ROOMS, all if that is empty. Its commands are those of the build in BINARY
# without the precompiled header, which is another compiler's.
file(READ ${BINARY}/compile_commands.json commands)
string(REGEX REPLACE " -Winvalid-pch -include [^ ]*cmake_pch.hxx" "" commands "${commands}")
file(WRITE ${BINARY}/clang-tidy/compile_commands.json "${commands}")
string(REPLACE " " "|" rooms "${ROOMS}")
if(rooms STREQUAL "")
  set(rooms "[a-z_]+")
endif()
execute_process(COMMAND ${RUN_CLANG_TIDY} -quiet -p ${BINARY}/clang-tidy "${SOURCE}/src/(${rooms})/.*[.]cpp$"
  OUTPUT_VARIABLE output ERROR_VARIABLE ignored RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${output}")
endif()
