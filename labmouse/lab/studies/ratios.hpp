// Ratios of one mouse's score, and of other figures, to those of another mouse.
#pragma once

#include <string_view>
#include <vector>

#include "labmouse/lab/studies/study.hpp"

namespace labmouse {

/// The ratio of a figure of two mice in the same mazes.
struct FigureRatio {
  std::string_view figure;  ///< its name in tables: "score"
  int mazes = 0;            ///< number of mazes in which both mice have it
  PairedRatio found;        ///< ratio of the means over these mazes
};

/// The ratio of the score first, then those of the other figures that the world compares. A figure is left out where no
/// maze has it for both mice, or where some value is not above 0 (such as a score reduced by a bonus).
std::vector<FigureRatio> ratios_of(const Study& study, const Comparison& comparison);

}  // namespace labmouse
