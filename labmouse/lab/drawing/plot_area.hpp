// The area of a plot in an SVG picture: its axes, and what is drawn on it.
#pragma once

#include <string>
#include <string_view>

#include "labmouse/lab/drawing/axis.hpp"
#include "labmouse/lab/drawing/palette.hpp"

namespace labmouse::drawing {

/// Bounds in pixels. Ticks and labels are outside and need 76 pixels on the left and 48 below.
struct PlotArea {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
};

/// Mean width of a letter in pixels, in the wider sans-serif fonts.
inline constexpr int letter_width = 7;

/// A straight line; and a text at a point, by `anchor` (`start`, `middle`, `end`).
std::string line_svg(double x1, double y1, double x2, double y2, const Tone& tone, int width);
std::string text_svg(double x, double y, std::string_view anchor, const Tone& tone, std::string_view words);

/// Lines at the ticks of y, the two axes with their ticks, and their labels, cut where they are too long.
std::string axes_svg(const PlotArea& area, const Axis& x, const Axis& y, std::string_view x_label,
                     std::string_view y_label);

}  // namespace labmouse::drawing
