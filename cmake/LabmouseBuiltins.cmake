# Files that the program carries with it, so that it has them wherever it is installed.

# labmouse_builtins(KIND PACKAGE TYPE ENDING [FOLDER]): embeds FOLDER/*.ENDING, or KIND/*.ENDING without a FOLDER, as the function
# builtin_KIND of labmouse/lab/PACKAGE/builtin_KIND.hpp.
set(LABMOUSE_BUILTINS_SOURCES)
function(labmouse_builtins kind package type ending)
  set(source ${PROJECT_BINARY_DIR}/generated/builtin_${kind}.cpp)
  set(folder ${PROJECT_SOURCE_DIR}/${kind})
  if(ARGC GREATER 4)
    set(folder ${PROJECT_SOURCE_DIR}/${ARGV4})
  endif()
  file(GLOB files CONFIGURE_DEPENDS ${folder}/*.${ending})
  add_custom_command(OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DKIND=${kind} -DPACKAGE=${package} -DTYPE=${type} -DENDING=${ending} -DFOLDER=${folder}
            -DOUTPUT=${source} -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/embed_files.cmake
    DEPENDS ${files} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/embed_files.cmake
    COMMENT "Embedding the ${kind}")
  set(LABMOUSE_BUILTINS_SOURCES ${LABMOUSE_BUILTINS_SOURCES} ${source} PARENT_SCOPE)
endfunction()

labmouse_builtins(mazes mazes BuiltinMaze txt)
labmouse_builtins(robots robots BuiltinRobot toml)
labmouse_builtins(rules robots BuiltinRules toml)
labmouse_builtins(boards robots BuiltinBoard toml)
labmouse_builtins(failure_rates failure_rates BuiltinRates json)
labmouse_builtins(templates league BuiltinTemplate py templates/robots)
