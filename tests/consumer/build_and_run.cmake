# cmake -DBUILD=dir -DPROJECT=dir -DGENERATOR=name -DCXX=path -DTYPE=name -DFLAGS=flags -P build_and_run.cmake
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
step(${CMAKE_COMMAND} -S ${PROJECT} -B ${folder}/build -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${CXX}
     -DCMAKE_BUILD_TYPE=${TYPE} -DCMAKE_CXX_FLAGS=${FLAGS} -DCMAKE_PREFIX_PATH=${folder}/installed)
step(${CMAKE_COMMAND} --build ${folder}/build)
if(EXISTS ${folder}/build/library)
  step(${CMAKE_COMMAND} -E chdir ${folder}/build ./library)
  message("${output}")
endif()
step(${folder}/build/one_eyed)
message("${output}")
file(REMOVE_RECURSE ${folder})
