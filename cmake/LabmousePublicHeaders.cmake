# The headers that other projects may include: what they declare is documented and kept, docs/library.md describes them,
# and tests/consumer uses them. All others are details: installed because these include them, and free to change.
set(LABMOUSE_PUBLIC_HEADERS
  labmouse/grid/cell.hpp
  labmouse/grid/cell_set.hpp
  labmouse/grid/heading.hpp
  labmouse/grid/wall.hpp
  labmouse/grid/wall_set.hpp
  labmouse/chance/dice.hpp
  labmouse/maze/maze.hpp
  labmouse/maze/formats/format.hpp
  labmouse/maze/generators/generator.hpp
  labmouse/maze/inspect.hpp
  labmouse/mouse/action.hpp
  labmouse/mouse/briefing.hpp
  labmouse/mouse/distance.hpp
  labmouse/mouse/explorer.hpp
  labmouse/mouse/knowledge.hpp
  labmouse/mouse/motion.hpp
  labmouse/mouse/pose.hpp
  labmouse/mouse/sighting.hpp
  labmouse/mouse/strategy.hpp
  labmouse/strategies/parameter.hpp
  labmouse/strategies/roster.hpp
  labmouse/contest/record.hpp
  labmouse/contest/rules.hpp
  labmouse/contest/score.hpp
  labmouse/contest/simulator.hpp
  labmouse/lab/bounds/bounds.hpp
  labmouse/lab/drawing/drawing.hpp
  labmouse/lab/mazes/maze_files.hpp
  labmouse/lab/mice/contestant.hpp
  labmouse/lab/mice/specs.hpp
  labmouse/lab/records/record_file.hpp
  labmouse/lab/system/files.hpp
)

# Parts of one source file, which compiles them twice with different settings: nobody else can include them.
set(LABMOUSE_HEADERS_OF_ONE_FILE
  labmouse/mouse/distance_rows.hpp
  labmouse/mouse/distance_searches.hpp
  labmouse/mouse/distance_strips.hpp
)
