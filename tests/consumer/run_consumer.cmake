# SPDX-License-Identifier: Apache-2.0
# Installs jprim into an empty folder, then configures, builds and runs the consumer project against it.
include(${CMAKE_CURRENT_LIST_DIR}/consumer.cmake)

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${JPRIM_BUILD} --prefix ${WORK}/prefix)
run_consumer(build ${BUILD_TYPE} -D CMAKE_CXX_STANDARD=${CXX_STANDARD} -D CMAKE_PREFIX_PATH=${WORK}/prefix
  -D WITH_PLUGIN=${WITH_PLUGIN})
if(WITH_PLUGIN)
  run(${WORK}/build/plugin_host)
endif()
