# SPDX-License-Identifier: Apache-2.0
# Builds jprim as a shared library, installs it into an empty folder, and lets the installed command and programs that
# know no CMake use it; those against the static library too.
include(${CMAKE_CURRENT_LIST_DIR}/consumer.cmake)

# Compiles the consumer's program as pkg-config says, after flags of the user's own; runs it.
function(run_by_pkg_config name prefix)
  file(GLOB_RECURSE pc_file ${prefix}/jprim.pc)
  get_filename_component(pc_folder "${pc_file}" DIRECTORY)
  set(ENV{PKG_CONFIG_PATH} ${pc_folder})
  foreach(what cflags libs)
    execute_process(COMMAND ${PKG_CONFIG} --${what} jprim OUTPUT_VARIABLE ${what} OUTPUT_STRIP_TRAILING_WHITESPACE
      COMMAND_ERROR_IS_FATAL ANY)
    separate_arguments(${what} UNIX_COMMAND "${${what}}")
  endforeach()
  separate_arguments(own UNIX_COMMAND "${CXX_FLAGS}")
  set(compile ${CXX} ${own} -std=c++17 -DNDEBUG ${cflags})
  if(NOT EXISTS ${WORK}/main.o)  # the same for both libraries
    run(${compile} -c ${SOURCE}/main.cpp -o ${WORK}/main.o)
    execute_process(COMMAND ${compile} -DNDEBUG -E ${SOURCE}/main.cpp OUTPUT_QUIET ERROR_VARIABLE complaint
      RESULT_VARIABLE result)
    if(FORBIDS_NDEBUG AND (result EQUAL 0 OR NOT complaint MATCHES "Compile with -UNDEBUG after all other flags"))
      message(FATAL_ERROR "NDEBUG is not refused, or not with the remedy:\n${complaint}")
    endif()
  endif()
  run(${CXX} ${own} ${WORK}/main.o -o ${WORK}/${name} ${libs})
  get_filename_component(libraries ${pc_folder} DIRECTORY)
  run(${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${libraries} ${WORK}/${name})
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} -S ${JPRIM_SOURCE} -B ${WORK}/build -G Ninja -D CMAKE_BUILD_TYPE=${BUILD_TYPE}
  -D CMAKE_CXX_COMPILER=${CXX} -D "CMAKE_CXX_FLAGS=${CXX_FLAGS}" -D JPRIM_BUILD_TESTS=OFF -D BUILD_SHARED_LIBS=ON
  ${reuse_objects})
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${CMAKE_COMMAND} --install ${WORK}/build --prefix ${WORK}/shared)
run(${CMAKE_COMMAND} -E rename ${WORK}/build ${WORK}/elsewhere)  # the installed command needs the installed library
run(${WORK}/shared/bin/jprim --version)
run(${CMAKE_COMMAND} --install ${JPRIM_BUILD} --prefix ${WORK}/static)
run_by_pkg_config(shared_program ${WORK}/shared)
run_by_pkg_config(static_program ${WORK}/static)
