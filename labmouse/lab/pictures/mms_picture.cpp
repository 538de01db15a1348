#include "labmouse/lab/pictures/mms_picture.hpp"

#include <fmt/format.h>

#include <array>

namespace labmouse {
namespace {

/// The 256-colour terminal codes of mms's colours, in the order of mms_colours.
constexpr std::array<int, mms_colours.size()> terminal_colours = {16, 21, 248, 51, 46,  214, 196, 231, 226,
                                                                  18, 30, 240, 28, 130, 88,  54,  100};

int terminal_colour(char colour) {
  const auto place = mms_colours.find(colour);
  return colour == 0 || place == std::string_view::npos ? 0 : terminal_colours[place];
}

std::string trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(' ');
  if (begin == std::string_view::npos) return "";
  return std::string(text.substr(begin, text.find_last_not_of(' ') - begin + 1));
}

}  // namespace

DrawingLayers mms_layers(const MmsCanvas& canvas, const HalfPose& pose) {
  DrawingLayers layers;
  layers.coordinates = true;
  layers.label = [&canvas](Cell cell) { return trimmed(canvas.text(cell)); };
  layers.paint = [&canvas](Cell cell) { return terminal_colour(canvas.colour(cell)); };
  layers.mouse = Pose{cell_of(pose.place), heading_of(pose.heading)};
  return layers;
}

std::string place_text(const HalfPose& pose) {
  const auto in_cells = [](int halves) { return (halves - 1) / 2.0; };
  return fmt::format("at ({:g},{:g}) heading {}", in_cells(pose.place.x), in_cells(pose.place.y),
                     name_of(pose.heading));
}

}  // namespace labmouse
