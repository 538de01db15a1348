#include "labmouse/lab/replays/mms_drawing.hpp"

#include <fmt/format.h>

#include "labmouse/lab/pictures/mms_picture.hpp"
#include "labmouse/lab/records/mms_statistics_json.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {

std::string draw_mms_run(const std::string& mouse, const NamedMaze& maze, const MmsRun& run, const MmsWalk& walk) {
  DrawingLayers layers = mms_layers(run.canvas, run.pose);
  layers.route = walk.poses();
  layers.title = is_scored(run) ? fmt::format("{} in {}: score {:g}", mouse, maze.name, decimal(run.statistics.score))
                                : fmt::format("{} in {}: {}{}", mouse, maze.name,
                                              run.statistics.finished ? "" : "unfinished, ", run.end);
  return draw_svg(as_in_mms(maze.maze), layers);
}

std::string mms_drawing_of(const Maze& maze, const MmsCanvas& canvas, const HalfPose& pose, const TextDrawer& draw) {
  return draw(as_in_mms(maze), mms_layers(canvas, pose));
}

std::string mms_frame(const Maze& maze, const MmsEvent& event, const MmsHost& host, const TextDrawer& draw) {
  return fmt::format("{}{:>7.2f} s  {}  {}{}\n", mms_drawing_of(maze, host.canvas(), event.pose, draw), event.clock,
                     place_text(event.pose), shown(event.line),
                     event.reply.empty() ? "" : fmt::format(" -> {}", event.reply));
}

}  // namespace labmouse
