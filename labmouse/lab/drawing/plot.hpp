// A plot of measured means against a parameter value.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "labmouse/lab/numbers/statistics.hpp"

namespace labmouse {

struct PlotPoint {
  /// A number such as 0.25. If any point's `x` is not a number, all points stand side by side, labelled by their texts.
  std::string x;
  double mean = 0.0;
  std::optional<Interval> interval;
  bool hollow = false;  ///< drawn as a ring
  std::string words;    ///< tooltip
};

/// What to draw. Texts may come from untrusted sources: the drawing escapes them.
struct Plot {
  std::string title;
  std::string description;
  std::string x_label, y_label;  ///< with units
  std::vector<PlotPoint> points;
  /// For the legend: what a dot, a whisker and a ring mean. The legend lists only what is drawn.
  std::string mean_words, interval_words, hollow_words;
};

/// One self-contained SVG picture like those of mazes, see draw_svg.
std::string draw_plot(const Plot& plot);

}  // namespace labmouse
