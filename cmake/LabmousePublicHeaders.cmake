# The headers that other projects may include: what they declare is documented and kept, docs/how-to/use-the-library.md describes them,
# and tests/consumer uses them.
set(LABMOUSE_PUBLIC_HEADERS
  labmouse/grid/cell.hpp
  labmouse/grid/cell_set.hpp
  labmouse/grid/heading.hpp
  labmouse/grid/wall.hpp
  labmouse/grid/wall_set.hpp
  labmouse/chance/rng.hpp
  labmouse/maze/maze.hpp
  labmouse/maze/formats/format.hpp
  labmouse/maze/generators/generator.hpp
  labmouse/maze/inspect.hpp
  labmouse/mouse/action.hpp
  labmouse/mouse/briefing.hpp
  labmouse/mouse/distance.hpp
  labmouse/mouse/drive/drive_fields.hpp
  labmouse/mouse/driving_explorer.hpp
  labmouse/mouse/driving_strategy.hpp
  labmouse/mouse/explorer.hpp
  labmouse/mouse/knowledge.hpp
  labmouse/mouse/motion.hpp
  labmouse/mouse/pose.hpp
  labmouse/mouse/robot/drive_model.hpp
  labmouse/mouse/robot/robot.hpp
  labmouse/mouse/sighting.hpp
  labmouse/mouse/strategy.hpp
  labmouse/controller/parts.hpp
  labmouse/strategies/parameter.hpp
  labmouse/strategies/builtin_mice.hpp
  labmouse/contest/code_contest.hpp
  labmouse/contest/drive.hpp
  labmouse/contest/drive_rules.hpp
  labmouse/contest/drive_score.hpp
  labmouse/contest/physical.hpp
  labmouse/contest/record.hpp
  labmouse/contest/rules.hpp
  labmouse/contest/score.hpp
  labmouse/contest/simulator.hpp
  labmouse/lab/bounds/bounds.hpp
  labmouse/lab/drawing/drawing.hpp
  labmouse/lab/mazes/maze_files.hpp
  labmouse/lab/mice/contestant.hpp
  labmouse/lab/mice/parts_in_c.hpp
  labmouse/lab/mice/controller_in_c.hpp
  labmouse/lab/mice/specs.hpp
  labmouse/lab/records/record_file.hpp
  labmouse/lab/robots/robot_files.hpp
  labmouse/lab/system/files.hpp
)
if(NOT LABMOUSE_LAB)
  list(FILTER LABMOUSE_PUBLIC_HEADERS EXCLUDE REGEX "^labmouse/lab/")
endif()

# What is installed: these, and what they include. Those others are details, free to change.
set(LABMOUSE_INSTALLED_HEADERS)
set(unread ${LABMOUSE_PUBLIC_HEADERS})
while(unread)
  list(POP_FRONT unread header)
  if(header IN_LIST LABMOUSE_INSTALLED_HEADERS)
    continue()
  endif()
  list(APPEND LABMOUSE_INSTALLED_HEADERS ${header})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${header})
  file(STRINGS ${PROJECT_SOURCE_DIR}/${header} lines REGEX "^#include \"labmouse/")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" included "${line}")
    list(APPEND unread ${included})
  endforeach()
endwhile()
