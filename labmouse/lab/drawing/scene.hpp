// What the layers of an SVG picture are drawn from, and the layers.
#pragma once

#include <string>
#include <vector>

#include "labmouse/lab/drawing.hpp"
#include "labmouse/lab/drawing/frame.hpp"
#include "labmouse/lab/drawing/heat.hpp"
#include "labmouse/lab/drawing/legs.hpp"

namespace labmouse::drawing {

struct Scene {
  const Maze& maze;
  const DrawingLayers& layers;
  Frame frame;
  Heat heat;
  std::vector<Leg> legs;

  /// Whether the middles of the cells belong to a route or to labels, so that letters move to a corner.
  bool crowded() const { return !legs.empty() || layers.label != nullptr; }
};

// From bottom to top. Each returns SVG elements, or nothing where the scene has nothing for it.

/// Heat, start and goals.
std::string floor_svg(const Scene& scene);
/// Posts, unknown walls and walls, the latter as one path with one segment a wall.
std::string walls_svg(const Scene& scene);
/// The letters S and G, and the labels.
std::string labels_svg(const Scene& scene);
/// The numbers of columns and rows, outside of the maze.
std::string coordinates_svg(const Scene& scene);
/// The walk, and a numbered dot at the end of each step.
std::string route_svg(const Scene& scene);
/// The mouse where it stands.
std::string mouse_svg(const Scene& scene);

/// A dot with the number of a step; `about` is its tooltip.
std::string stop_svg(Point at, int step, const std::string& about);
/// A mouse that looks in a heading.
std::string mouse_svg(Point at, Heading heading);
/// A line along unknown walls; `path` is the path's data.
std::string unknown_svg(const std::string& path);

}  // namespace labmouse::drawing
