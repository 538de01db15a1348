#include "labmouse/lab/mms/mms_drawing.hpp"

#include <fmt/format.h>

#include "labmouse/lab/pictures/mms_picture.hpp"
#include "labmouse/lab/records/mms_statistics_json.hpp"

namespace labmouse {

std::string draw_mms_run(const std::string& mouse, const NamedMaze& maze, const MmsRun& run, const MmsWalk& walk) {
  DrawingLayers layers = mms_layers(run.canvas, run.pose);
  layers.route = walk.poses();
  layers.title = is_scored(run) ? fmt::format("{} in {}: score {:g}", mouse, maze.name, decimal(run.statistics.score))
                                : fmt::format("{} in {}: {}{}", mouse, maze.name,
                                              run.statistics.solved ? "" : "unsolved, ", run.end);
  return draw_svg(as_in_mms(maze.maze), layers);
}

}  // namespace labmouse
