// A measured mean against a value, as a picture.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "labmouse/lab/numbers/statistics.hpp"

namespace labmouse {

struct PlotPoint {
  /// A number such as 0.25; where one point's is none, all points stand side by side under their texts.
  std::string x;
  double mean = 0.0;
  std::optional<Interval> interval;
  bool hollow = false;  ///< drawn as a ring
  std::string words;    ///< shown where a pointer rests on it
};

/// What to draw. Texts may come from anywhere: the drawing makes them harmless.
struct Plot {
  std::string title;
  std::string description;
  std::string x_label, y_label;  ///< with units
  std::vector<PlotPoint> points;
  /// For the legend: what a dot, a whisker and a ring say. What is not drawn is not in the legend.
  std::string mean_words, interval_words, hollow_words;
};

/// One self-contained SVG picture like those of mazes, see draw_svg.
std::string draw_plot(const Plot& plot);

}  // namespace labmouse
