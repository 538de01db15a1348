// The layers of an SVG picture, and the input from which they are drawn.
#pragma once

#include <string>
#include <vector>

#include "labmouse/lab/drawing/drawing.hpp"
#include "labmouse/lab/drawing/frame.hpp"
#include "labmouse/lab/drawing/heat.hpp"
#include "labmouse/lab/drawing/legend.hpp"
#include "labmouse/lab/drawing/legs.hpp"
#include "labmouse/lab/drawing/palette.hpp"

namespace labmouse::drawing {

struct Scene {
  const Maze& maze;
  const DrawingLayers& layers;
  Frame frame;
  Heat heat;
  std::vector<Leg> legs;

  /// How many rims (Frame::rim) the squares of start and goal are inset, so that the colours below them are visible.
  int rims() const { return (layers.explored ? 1 : 0) + (heat.peak() > 0 ? 1 : 0); }
  /// Whether lines pass through the middles of cells; labels then move to a corner.
  bool lined() const { return !legs.empty() || layers.search_run; }
  /// Whether lines or labels use the middles of cells; the letters S and G then move to a corner.
  bool crowded() const { return lined() || layers.label != nullptr; }
};

// From bottom to top. Each returns SVG elements; empty if the scene has no such layer.

/// Explored cells, heat, start and goals.
std::string floor_svg(const Scene& scene);
/// Posts, unknown walls, closed walls and wrong guesses. All closed walls are one path, and all wrong guesses another,
/// with one segment for each wall.
std::string walls_svg(const Scene& scene);
/// The two legs of the search run as lines; the second one dashed, so that it differs not only in colour.
std::string search_run_svg(const Scene& scene);
/// The letters S and G, and the labels.
std::string labels_svg(const Scene& scene);
/// The numbers of columns and rows, outside of the maze.
std::string coordinates_svg(const Scene& scene);
/// The candidate walls of the choice, with the costs of their runs.
std::string candidates_svg(const Scene& scene);
/// The walk, and a numbered dot at the end of each step.
std::string route_svg(const Scene& scene);
/// The mouse where it stands.
std::string mouse_svg(const Scene& scene);

/// The rows of samples with words under the maze.
Legend legend_of(const Scene& scene, Point begin, int right);

/// The data of a path along a wall.
std::string segment(const Frame& frame, Wall wall);
/// A line along the wall of a candidate; `worth` says whether it was worth the way.
std::string candidate_svg(const std::string& path, bool chosen, bool worth);
/// The data of a path through points.
std::string path_through(const std::vector<Point>& points);
/// A dot with the number of a step; `about` is its tooltip.
std::string stop_svg(Point at, int step, const std::string& about);
/// A mouse that looks in a heading.
std::string mouse_svg(Point at, Heading heading);
/// A line along unknown walls; `path` is the path's data.
std::string unknown_svg(const std::string& path);
/// A line of the thickness of walls.
std::string wall_svg(const Tone& tone, const std::string& path);
/// A line of a leg of the search run.
std::string leg_svg(const Tone& tone, const std::string& path);

}  // namespace labmouse::drawing
