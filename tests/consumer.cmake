# Installs the build tree under `work`, then configures, builds and runs the project in `source`
# against what was installed. Run by ctest; see tests/CMakeLists.txt.

set(prefix ${work}/prefix)
file(REMOVE_RECURSE ${work})

execute_process(COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET
  COMMAND ${CMAKE_COMMAND} --install ${build} --config ${config} --prefix ${prefix})
execute_process(COMMAND_ERROR_IS_FATAL ANY
  COMMAND ${CMAKE_COMMAND} -S ${source} -B ${work}/build -G ${generator}
    -D CMAKE_BUILD_TYPE=${config} -D CMAKE_PREFIX_PATH=${prefix}
    -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_CXX_FLAGS=${flags}
    -D CMAKE_RUNTIME_OUTPUT_DIRECTORY=${work}/bin -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
execute_process(COMMAND_ERROR_IS_FATAL ANY
  COMMAND ${CMAKE_COMMAND} --build ${work}/build --config ${config})
find_program(consumer consumer PATHS ${work}/bin ${work}/bin/${config}
  NO_DEFAULT_PATH NO_CACHE REQUIRED)
execute_process(COMMAND_ERROR_IS_FATAL ANY COMMAND ${consumer} OUTPUT_VARIABLE output)
if(NOT output MATCHES "genus 0")
  message(FATAL_ERROR "expected 'genus 0' in: ${output}")
endif()
