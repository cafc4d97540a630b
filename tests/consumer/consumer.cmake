# SPDX-License-Identifier: Apache-2.0
# What the test scripts here have in common.
include(${CMAKE_CURRENT_LIST_DIR}/../support/run.cmake)

# Configures, builds and runs the consumer project in a folder of WORK.
function(run_consumer folder build_type)
  run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/${folder} -G Ninja -D CMAKE_BUILD_TYPE=${build_type}
    -D CMAKE_CXX_COMPILER=${CXX} -D "CMAKE_CXX_FLAGS=${CXX_FLAGS}" ${ARGN})
  run(${CMAKE_COMMAND} --build ${WORK}/${folder})
  run(${WORK}/${folder}/consumer)
endfunction()

# Options for a build of jprim itself that takes the objects of JPRIM_BUILD instead of compiling them again.
set(ENV{JPRIM_OBJECTS} ${JPRIM_BUILD})
set(reuse_objects -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON
  -D CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CURRENT_LIST_DIR}/reuse_objects)
