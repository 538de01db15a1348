// Mazes for documents: one SVG file that needs nothing else. The layers come from the folder drawing; here they are put
// on one sheet with title, description and legend.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "labmouse/lab/drawing.hpp"
#include "labmouse/lab/drawing/legend.hpp"
#include "labmouse/lab/drawing/palette.hpp"
#include "labmouse/lab/drawing/scene.hpp"
#include "labmouse/lab/printable.hpp"

namespace labmouse {
namespace {

using namespace drawing;

constexpr int margin = 20;
constexpr int least_width = 300;  // pixels; small mazes have titles and legends, too

std::string counted(int count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

Scene scene_of(const Maze& maze, const DrawingLayers& layers) {
  const int left = margin + (layers.coordinates ? 12 : 0);
  const int top = margin + (layers.title.empty() ? 0 : 32);
  return {maze, layers, Frame{maze.size(), {left, top}}, Heat(maze.size(), layers.visits), legs_of(maze, layers.route)};
}

int width_of(const Scene& scene) { return std::max(scene.frame.right() + margin, least_width); }

std::string route_words(const Scene& scene) {
  return counted(static_cast<int>(scene.legs.size()), "step", "steps") + ", " +
         counted(length_of(scene.legs), "cell", "cells");
}

/// What the picture shows, in words, for those who cannot see it.
std::string description_of(const Scene& scene) {
  const Maze& maze = scene.maze;
  std::string text =
      fmt::format("A maze of {} by {} cells; start ({},{}), {}.", maze.size().width, maze.size().height, maze.start().x,
                  maze.start().y, counted(maze.goals().count(), "goal cell", "goal cells"));
  if (!scene.legs.empty()) text += fmt::format(" Route: {}.", route_words(scene));
  if (scene.heat.peak() > 0) text += fmt::format(" Most visits to a cell: {}.", scene.heat.peak());
  if (const auto& unknown = scene.layers.unknown)
    text += fmt::format(" Not known: {}.", counted(unknown->count(), "wall", "walls"));
  return text;
}

std::string title_svg(const Scene& scene) {
  constexpr int letter_width = 10;
  std::u32string title = printable(scene.layers.title);
  const auto room = static_cast<std::size_t>((width_of(scene) - scene.frame.origin.x - margin) / letter_width);
  if (title.empty()) return "";
  if (title.size() > room) title = title.substr(0, room - 1) + U'…';
  return fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"16\" font-weight=\"600\" {}>{}</text>\n",
                     scene.frame.origin.x, margin + 14, fill(ink), xml_escaped(utf8(title)));
}

std::string swatch(const Tone& tone, char letter) {
  return fmt::format(
      "<rect y=\"-9\" width=\"18\" height=\"18\" rx=\"2\" {}/><text x=\"9\" y=\"4\" font-size=\"11\" "
      "font-weight=\"600\" text-anchor=\"middle\" {}>{}</text>",
      fill(tone), fill(ink), letter);
}

std::string route_sample() {
  return fmt::format(
      "<path {} stroke-width=\"4\" stroke-linecap=\"round\" stroke-opacity=\"0.8\" d=\"M2 0h24\"/>"
      "<circle cx=\"26\" cy=\"0\" r=\"6\" {}/>",
      stroke(route), fill(route));
}

void add_heat(Legend& legend, const Heat& heat) {
  constexpr int step = 12;
  const int shown = heat.peak() == 1 ? 1 : Heat::levels;
  std::string ramp;
  for (int level = 0; level < shown; ++level)
    ramp += fmt::format("<rect x=\"{}\" y=\"-7\" width=\"{}\" height=\"14\" {}/>", level * step, step,
                        fill(heat_tones[static_cast<std::size_t>(level)]));
  legend.add(shown * step, ramp,
             heat.peak() == 1 ? "1 visit to a cell" : fmt::format("1 to {} visits to a cell", heat.peak()));
}

Legend legend_of(const Scene& scene) {
  const int top = scene.frame.bottom() + (scene.layers.coordinates ? 24 : 4) + margin;
  Legend legend({scene.frame.origin.x, top}, width_of(scene) - margin);
  legend.add(18, swatch(start, 'S'), "start");
  legend.add(18, swatch(goal, 'G'), "goal");
  if (!scene.legs.empty()) legend.add(32, route_sample(), route_words(scene));
  if (scene.heat.peak() > 0) add_heat(legend, scene.heat);
  if (scene.layers.unknown) legend.add(28, unknown_svg("M0 0h28"), "unknown wall");
  if (scene.layers.mouse) legend.add(22, mouse_svg(Point{11, 0}, Heading::north), "mouse");
  if (scene.layers.label && !scene.layers.label_meaning.empty())
    legend.add(22, fmt::format("<text y=\"5\" font-size=\"12\" {}>123</text>", fill(ink)), scene.layers.label_meaning);
  return legend;
}

std::string head(const Scene& scene, int height) {
  const std::string& title = scene.layers.title;
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"labmouse\" role=\"img\" viewBox=\"0 0 {0} {1}\" "
      "width=\"{0}\" height=\"{1}\">\n<title>{2}</title>\n<desc>{3}</desc>\n<style>{4}</style>\n"
      "<rect width=\"{0}\" height=\"{1}\" {5}/>\n"
      "<g font-family=\"system-ui, -apple-system, 'Segoe UI', 'Liberation Sans', sans-serif\" font-size=\"13\">\n",
      width_of(scene), height, xml_escaped(title.empty() ? "Maze" : title), xml_escaped(description_of(scene)),
      dark_style_sheet(), fill(paper));
}

}  // namespace

std::string draw_svg(const Maze& maze, const DrawingLayers& layers) {
  const Scene scene = scene_of(maze, layers);
  const Legend legend = legend_of(scene);
  return head(scene, legend.bottom() + margin / 2) + title_svg(scene) + floor_svg(scene) + walls_svg(scene) +
         labels_svg(scene) + route_svg(scene) + mouse_svg(scene) + coordinates_svg(scene) + legend.svg() +
         "</g>\n</svg>\n";
}

}  // namespace labmouse
