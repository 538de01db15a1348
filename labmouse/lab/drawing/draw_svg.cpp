// Mazes as self-contained SVG files: puts the layers on one sheet with title, description and legend.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "labmouse/lab/drawing/drawing.hpp"
#include "labmouse/lab/drawing/scene.hpp"
#include "labmouse/lab/drawing/sheet.hpp"
#include "labmouse/lab/drawing/words.hpp"
#include "labmouse/lab/text/counted.hpp"

namespace labmouse {
namespace {

using namespace drawing;

Scene scene_of(const Maze& maze, const DrawingLayers& layers) {
  const int left = sheet_margin + (layers.coordinates ? 12 : 0);
  const int top = sheet_margin + (layers.title.empty() ? 0 : 32);
  return {maze, layers, Frame{maze.size(), {left, top}}, Heat(maze.size(), layers.visits), legs_of(maze, layers.route)};
}

int width_of(const Scene& scene) { return std::max(scene.frame.right() + sheet_margin, least_sheet_width); }

/// Describes the picture in words, for screen readers.
std::string description_of(const Scene& scene) {
  const Maze& maze = scene.maze;
  std::string text =
      fmt::format("A maze of {} by {} cells; start ({},{}), {}.", maze.size().width, maze.size().height, maze.start().x,
                  maze.start().y, counted(maze.goals().count(), "goal cell", "goal cells"));
  if (!scene.legs.empty()) text += fmt::format(" Route: {}.", route_words(scene.legs));
  if (scene.heat.peak() > 0) text += fmt::format(" Most visits to a cell: {}.", scene.heat.peak());
  if (const auto& unknown = scene.layers.unknown)
    text += fmt::format(" Not known: {}.", counted(unknown->count(), "wall", "walls"));
  if (const auto& search_run = scene.layers.search_run) {
    text += fmt::format(" Search: {}", to_goal_words(*search_run));
    text += search_run->onwards.empty() ? "." : fmt::format(", {}.", onwards_words(*search_run));
  }
  if (scene.layers.wrong) text += fmt::format(" {}.", wrong_words(scene.layers));
  if (scene.layers.false_walls) text += fmt::format(" {}.", false_words(*scene.layers.false_walls));
  if (const auto& explored = scene.layers.explored)
    text += fmt::format(" {}, {}.", visited_words(*explored), discovered_words(*explored));
  if (const auto& choice = scene.layers.candidates)
    text += fmt::format(" {}; {}.", candidates_words(*choice), chosen_words(choice->reasons));
  return text;
}

Legend legend_below(const Scene& scene) {
  const int top = scene.frame.bottom() + (scene.layers.coordinates ? 24 : 4) + sheet_margin;
  return legend_of(scene, {scene.frame.origin.x, top}, width_of(scene) - sheet_margin);
}

/// The tones that only these layers need.
std::vector<Tone> tones_of(const DrawingLayers& layers) {
  std::vector<Tone> tones;
  if (layers.search_run || layers.false_walls) tones.push_back(to_goal);
  if (layers.search_run) tones.push_back(onwards);
  if (layers.wrong) tones.push_back(wrong);
  if (layers.candidates) tones.push_back(candidate);
  if (layers.explored) tones.insert(tones.end(), {discovered, visited});
  return tones;
}

}  // namespace

std::string draw_svg(const Maze& maze, const DrawingLayers& layers) {
  const Scene scene = scene_of(maze, layers);
  const Legend legend = legend_below(scene);
  const int right = width_of(scene) - sheet_margin;
  const Sheet sheet = {width_of(scene), legend.bottom() + sheet_margin / 2,
                       layers.title.empty() ? "Maze" : layers.title, description_of(scene), tones_of(layers)};
  return sheet.with(heading_svg({scene.frame.origin.x, sheet_margin + 14}, right, layers.title) + floor_svg(scene) +
                    walls_svg(scene) + search_run_svg(scene) + labels_svg(scene) + route_svg(scene) +
                    candidates_svg(scene) + mouse_svg(scene) + coordinates_svg(scene) + legend.svg());
}

}  // namespace labmouse
