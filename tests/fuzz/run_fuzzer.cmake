# SPDX-License-Identifier: Apache-2.0
# Builds a fuzzer with clang in a folder of its own and runs it on its corpus for a bounded number of
# executions: cmake -D FUZZER=<name> -D SOURCE=<project> -D WORK=<folder> -D RUNS=<number> -P run_fuzzer.cmake
include(${CMAKE_CURRENT_LIST_DIR}/../support/run.cmake)

run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK} -G Ninja -D CMAKE_CXX_COMPILER=clang++
  -D CMAKE_BUILD_TYPE=RelWithDebInfo -D JPRIM_BUILD_FUZZERS=ON -D JPRIM_BUILD_TESTS=OFF -D JPRIM_BUILD_TOOL=OFF)
run(${CMAKE_COMMAND} --build ${WORK} --target ${FUZZER}_fuzzer)
# New inputs go to the first folder, the corpus is only read.
file(MAKE_DIRECTORY ${WORK}/found)
run(${WORK}/bin/${FUZZER}_fuzzer -runs=${RUNS} -max_len=4096 -dict=${SOURCE}/tests/fuzz/${FUZZER}.dict
  -verbosity=0 ${WORK}/found ${SOURCE}/tests/fuzz/corpus/${FUZZER})
