// The layer of an SVG picture that shows the way of the search run.
#include <fmt/format.h>

#include "labmouse/lab/drawing/route_line.hpp"
#include "labmouse/lab/drawing/scene.hpp"

namespace labmouse::drawing {
namespace {

// Pixels right of the middle, so that the two lines are beside each other and clear of the dots of a route.
constexpr int to_goal_lane = 9;
constexpr int onwards_lane = 13;

std::string line_svg(const Scene& scene, const Tone& tone, const std::vector<Pose>& poses, int lane) {
  std::string path;
  for (const auto& points : route_line(scene.frame, legs_of(scene.maze, poses), lane).strokes)
    path += path_through(points);
  return leg_svg(tone, path);
}

}  // namespace

std::string leg_svg(const Tone& tone, const std::string& path) {
  if (path.empty()) return "";
  const std::string_view dashes = tone.name == onwards.name ? " stroke-dasharray=\"6 3\"" : "";
  return fmt::format("<path {} stroke-width=\"2.5\" stroke-linejoin=\"round\"{} d=\"{}\"/>\n", stroke(tone), dashes,
                     path);
}

std::string search_run_svg(const Scene& scene) {
  if (!scene.layers.search_run) return "";
  return line_svg(scene, onwards, scene.layers.search_run->onwards, onwards_lane) +
         line_svg(scene, to_goal, scene.layers.search_run->to_goal, to_goal_lane);
}

}  // namespace labmouse::drawing
