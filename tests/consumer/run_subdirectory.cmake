# SPDX-License-Identifier: Apache-2.0
# Builds and runs the consumer project with jprim as a folder of it.
include(${CMAKE_CURRENT_LIST_DIR}/consumer.cmake)

file(REMOVE_RECURSE ${WORK})
run_consumer(build "" -D JPRIM_SOURCE=${JPRIM_SOURCE} ${reuse_objects})
