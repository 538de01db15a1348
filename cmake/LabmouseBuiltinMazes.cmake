# Embeds mazes/*.txt in the program, so that it has them wherever it is installed.
set(LABMOUSE_BUILTIN_MAZES_SOURCE ${PROJECT_BINARY_DIR}/generated/builtin_mazes.cpp)
file(GLOB labmouse_maze_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/mazes/*.txt)
add_custom_command(OUTPUT ${LABMOUSE_BUILTIN_MAZES_SOURCE}
  COMMAND ${CMAKE_COMMAND} -DFOLDER=${PROJECT_SOURCE_DIR}/mazes -DOUTPUT=${LABMOUSE_BUILTIN_MAZES_SOURCE}
          -P ${CMAKE_CURRENT_LIST_DIR}/embed_mazes.cmake
  DEPENDS ${labmouse_maze_files} ${CMAKE_CURRENT_LIST_DIR}/embed_mazes.cmake
  COMMENT "Embedding the mazes")
