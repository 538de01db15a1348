#include "labmouse/lab/replays/fields.hpp"

#include "labmouse/lab/bounds/bounds.hpp"
#include "labmouse/lab/replays/maze_data.hpp"
#include "labmouse/mouse/distance.hpp"

namespace labmouse {

Json traits_json(const PlayTraits& traits) {
  return {{"clock", traits.in_steps ? "steps" : "seconds"},
          {"unit", traits.unit},
          {"digits", traits.digits},
          {"bound", traits.bound},
          {"runs", traits.runs},
          {"draws", traits.draws},
          {"pictured", traits.pictured}};
}

Json route_json(const Maze& maze, const Rules& rules) {
  Pose pose = {maze.start(), maze.start_heading()};
  const std::vector<Action> actions = shortest_run(maze, rules);
  Json cells = Json::array();
  if (!actions.empty()) cells.push_back(cell_json(pose.cell));
  for (const Action& action : actions) cells.push_back(cell_json((pose = after(pose, action)).cell));
  return cells;
}

Json distances_json(const Maze& maze, int stride) {
  DistanceField field(maze.size(), strides(stride));
  field.fill(maze.open_walls(), maze.goals());
  Json distances = Json::array();
  for (int i = 0; i < maze.size().area(); ++i) {
    const Cell cell = maze.size().cell_at(i);
    distances.push_back(field.reaches(cell) ? field.at(cell) : -1);
  }
  return distances;
}

}  // namespace labmouse
