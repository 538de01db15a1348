// The layers of an SVG picture that colour the floor. The upper of two layers is inset, so that a rim of the lower one
// is visible.
#include <fmt/format.h>

#include <array>

#include "labmouse/lab/drawing/scene.hpp"

namespace labmouse::drawing {
namespace {

/// Path data of a cell's square, inset by `rims` rims.
std::string square(const Frame& frame, Cell cell, int rims) {
  const Point at = frame.corner(cell).moved(rims * Frame::rim, rims * Frame::rim);
  return fmt::format("M{0} {1}h{2}v{2}h-{2}z", at.x, at.y, Frame::cell - 2 * rims * Frame::rim);
}

std::string area(const Tone& tone, const std::string& path) {
  if (path.empty()) return "";
  return fmt::format("<path {} shape-rendering=\"crispEdges\" d=\"{}\"/>\n", fill(tone), path);
}

std::string explored_svg(const Scene& scene) {
  if (!scene.layers.explored) return "";
  std::string stood_in;
  std::string only_shown;
  const ExploredCells& explored = *scene.layers.explored;
  explored.discovered.for_each(
      [&](Cell cell) { (explored.visited.contains(cell) ? stood_in : only_shown) += square(scene.frame, cell, 0); });
  return area(discovered, only_shown) + area(visited, stood_in);
}

std::string heat_svg(const Scene& scene) {
  std::array<std::string, Heat::levels + 1> areas;
  const int rims = scene.layers.explored ? 1 : 0;
  CellSet::all(scene.frame.size).for_each([&](Cell cell) {
    areas[static_cast<std::size_t>(scene.heat.level(cell))] += square(scene.frame, cell, rims);
  });
  std::string svg;
  for (std::size_t level = 1; level < areas.size(); ++level) svg += area(heat_tones[level - 1], areas[level]);
  return svg;
}

std::string plate(const Scene& scene, Cell cell, const Tone& tone) {
  const int rim = scene.rims() * Frame::rim;
  const Point corner = scene.frame.corner(cell).moved(rim, rim);
  return fmt::format("<rect x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{2}\" {3}/>\n", corner.x, corner.y,
                     Frame::cell - 2 * rim, fill(tone));
}

}  // namespace

std::string floor_svg(const Scene& scene) {
  std::string floor = explored_svg(scene) + heat_svg(scene);
  scene.maze.goals().for_each([&](Cell cell) { floor += plate(scene, cell, goal); });
  return floor + plate(scene, scene.maze.start(), start);
}

}  // namespace labmouse::drawing
