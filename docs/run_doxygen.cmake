# SPDX-License-Identifier: Apache-2.0
# cmake -D DOXYGEN=doxygen -D SOURCE=<project> -D OUTPUT=<folder> -P run_doxygen.cmake
# Writes the documentation of the public headers to OUTPUT/html; any warning is an error.
file(MAKE_DIRECTORY ${OUTPUT})
configure_file(${SOURCE}/docs/Doxyfile.in ${OUTPUT}/Doxyfile @ONLY)
execute_process(COMMAND ${DOXYGEN} ${OUTPUT}/Doxyfile RESULT_VARIABLE result)
if(result)
  message(FATAL_ERROR "doxygen has something to say; see above")
endif()
