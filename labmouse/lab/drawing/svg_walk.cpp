// The layers of an SVG picture that show what the mouse does.
#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/drawing/palette.hpp"
#include "labmouse/lab/drawing/route_line.hpp"
#include "labmouse/lab/drawing/scene.hpp"

namespace labmouse::drawing {
namespace {

constexpr int lane_width = 6;

/// Shifts dots that would cover each other (turns in place, further visits), up to four of them.
Point fanned(const std::vector<Point>& stops, std::size_t step) {
  const Point stop = stops[step];
  const auto end = stops.begin() + static_cast<std::ptrdiff_t>(step);
  const auto earlier = std::count(stops.begin(), end, stop);
  const int offset = 3 * static_cast<int>(earlier % 4);
  return stop.moved(offset, offset);
}

}  // namespace

std::string path_through(const std::vector<Point>& points) {
  std::string path;
  for (const Point point : points) path += fmt::format("{}{} {}", path.empty() ? 'M' : 'L', point.x, point.y);
  return path;
}

std::string stop_svg(Point at, int step, const std::string& about) {
  constexpr int radius = 8;
  return fmt::format("<g class=\"stop\"><title>{4}</title><circle cx=\"{0}\" cy=\"{1}\" r=\"{2}\" {3}/>", at.x, at.y,
                     radius, fill_and_stroke(route, paper), about) +
         fmt::format("<text x=\"{}\" y=\"{}\" {} font-size=\"{}\">{}</text></g>\n", at.x, at.y + 3, fill(paper),
                     step < 100 ? 9 : 7, step);
}

std::string mouse_svg(Point at, Heading heading) {
  return fmt::format(
      "<path {} stroke-width=\"2\" stroke-linejoin=\"round\" transform=\"translate({} {}) rotate({})\" "
      "d=\"M0 -13L10 11L0 7L-10 11z\"/>\n",
      fill_and_stroke(ink, paper), at.x, at.y, 90 * static_cast<int>(heading));
}

std::string route_svg(const Scene& scene) {
  if (scene.legs.empty()) return "";
  const RouteLine line = route_line(scene.frame, scene.legs, revisits(scene.legs) ? lane_width : 0);
  std::string svg;
  for (const auto& stroke_points : line.strokes)
    svg += fmt::format(
        "<path {} stroke-width=\"4\" stroke-linejoin=\"round\" stroke-linecap=\"round\" "
        "stroke-opacity=\"0.8\" d=\"{}\"/>\n",
        stroke(route), path_through(stroke_points));
  svg += "<g text-anchor=\"middle\" font-weight=\"600\">\n";
  for (std::size_t step = 0; step < line.stops.size(); ++step) {
    const Pose& pose = scene.layers.route[step + 1];
    const auto about = fmt::format("step {}: ({},{}) {}", step + 1, pose.cell.x, pose.cell.y, name_of(pose.heading));
    svg += stop_svg(fanned(line.stops, step), static_cast<int>(step + 1), about);
  }
  return svg + "</g>\n";
}

std::string mouse_svg(const Scene& scene) {
  if (!scene.layers.mouse) return "";
  return mouse_svg(scene.frame.centre(scene.layers.mouse->cell), scene.layers.mouse->heading);
}

}  // namespace labmouse::drawing
