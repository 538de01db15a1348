# cmake -DBUILD=dir -DFOLDER=dir -DSOURCE=dir -DGENERATOR=name -DCXX=path -DTYPE=name -P build_and_run.cmake
execute_process(COMMAND mktemp -d -t labmouse-consumer-XXXXXX OUTPUT_VARIABLE folder OUTPUT_STRIP_TRAILING_WHITESPACE
                COMMAND_ERROR_IS_FATAL ANY)

function(step)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE failed)
  set(output "${output}" PARENT_SCOPE)
  if(failed)
    file(REMOVE_RECURSE ${folder})
    message(FATAL_ERROR "${ARGN}\n${output}")
  endif()
endfunction()

step(${CMAKE_COMMAND} --install ${BUILD} --prefix ${folder}/installed)
if(EXISTS ${folder}/installed/bin/labmouse)
  step(${folder}/installed/bin/labmouse race --mice flood --mazes contest-01)
endif()
step(${CMAKE_COMMAND} -S ${FOLDER}/project -B ${folder}/build -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${CXX}
     -DCMAKE_BUILD_TYPE=${TYPE} -DCMAKE_PREFIX_PATH=${folder}/installed)
step(${CMAKE_COMMAND} --build ${folder}/build)
if(EXISTS ${folder}/build/library)
  step(${CMAKE_COMMAND} -E chdir ${folder}/build ./library)
  message("${output}")
endif()
step(${folder}/build/one_eyed)
message("${output}")
set(output_of_one_eyed "${output}")

# The same without CMake.
find_program(PKG_CONFIG pkg-config)
if(PKG_CONFIG)
  file(GLOB_RECURSE pc ${folder}/installed/*/labmouse.pc)
  cmake_path(GET pc PARENT_PATH pc)
  step(sh -c "PKG_CONFIG_PATH=${pc} && export PKG_CONFIG_PATH && \
    ${CXX} -std=c++20 '${FOLDER}/project/one_eyed.cpp' $(${PKG_CONFIG} --cflags --libs labmouse) -o ${folder}/without_cmake")
  # Where the libraries are shared, nothing else tells it where they are.
  cmake_path(GET pc PARENT_PATH libraries)
  step(${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${libraries} ${folder}/without_cmake)
  if(NOT output STREQUAL output_of_one_eyed)
    message(FATAL_ERROR "what was built with pkg-config prints something else: ${output}")
  endif()
endif()

step(${CMAKE_COMMAND} -S ${FOLDER}/subproject -B ${folder}/subproject -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${CXX}
     -DLABMOUSE=${SOURCE})
step(${CMAKE_COMMAND} --install ${folder}/subproject --prefix ${folder}/of_subproject)
if(EXISTS ${folder}/of_subproject)
  message(FATAL_ERROR "a build that has labmouse in it installs labmouse, too")
endif()
file(REMOVE_RECURSE ${folder})
