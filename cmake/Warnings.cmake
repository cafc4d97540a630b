# SPDX-License-Identifier: Apache-2.0
# Warnings for our own code only: Simbody, Eigen and GoogleTest come in as system headers.
add_library(jprim_warnings INTERFACE)
target_compile_options(jprim_warnings INTERFACE -Wall -Wextra -Wpedantic)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 takes the strided loops of Simbody's small matrices and fmt's fill characters for overruns once
  # they are inlined into us.
  target_compile_options(jprim_warnings INTERFACE -Wno-array-bounds -Wno-stringop-overflow)
endif()
