# Embeds the bridge to capstone robots in the program, so that it has it wherever it is installed.
set(LABMOUSE_BRIDGE_SOURCE ${PROJECT_BINARY_DIR}/generated/capstone_bridge.cpp)
set(labmouse_bridge ${PROJECT_SOURCE_DIR}/labmouse/external/bridge)
add_custom_command(OUTPUT ${LABMOUSE_BRIDGE_SOURCE}
  COMMAND ${CMAKE_COMMAND} -DFOLDER=${labmouse_bridge} -DOUTPUT=${LABMOUSE_BRIDGE_SOURCE}
          -P ${CMAKE_CURRENT_LIST_DIR}/embed_bridge.cmake
  DEPENDS ${labmouse_bridge}/dialogue.py ${labmouse_bridge}/other_python.py ${labmouse_bridge}/capstone.py
          ${CMAKE_CURRENT_LIST_DIR}/embed_bridge.cmake
  COMMENT "Embedding the bridge")
