// The area of a plot in an SVG picture: its axes, and what is drawn on it.
#pragma once

#include <string>
#include <string_view>

#include "labmouse/lab/drawing/axis.hpp"
#include "labmouse/lab/drawing/palette.hpp"

namespace labmouse::drawing {

/// Pixels; ticks and labels stand outside: 76 on the left and 48 below hold them.
struct PlotArea {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
};

/// Pixels, about the mean of the wider sans-serif faces.
inline constexpr int letter_width = 7;

/// A straight line, and words that begin, have their middle or end there (`start`, `middle`, `end`).
std::string line_svg(double x1, double y1, double x2, double y2, const Tone& tone, int width);
std::string text_svg(double x, double y, std::string_view anchor, const Tone& tone, std::string_view words);

/// Lines at the ticks of y, the two axes with their ticks, and their labels, cut where they are too long.
std::string axes_svg(const PlotArea& area, const Axis& x, const Axis& y, std::string_view x_label,
                     std::string_view y_label);

}  // namespace labmouse::drawing
