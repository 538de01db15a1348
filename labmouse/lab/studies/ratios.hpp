// How much of one mouse's score another one takes, and of what else their world compares.
#pragma once

#include <string_view>
#include <vector>

#include "labmouse/lab/studies/study.hpp"

namespace labmouse {

/// A figure of one mouse over that of another one, in the same mazes.
struct FigureRatio {
  std::string_view figure;  ///< as tables call it: "score"
  int mazes = 0;            ///< in which both have it
  PairedRatio found;        ///< of the means over these mazes
};

/// The score first, then what the world compares besides. A figure is left out where there is no maze in which both
/// have it, or where it is not above 0 in one of them: a score less a bonus, say.
std::vector<FigureRatio> ratios_of(const Study& study, const Comparison& comparison);

}  // namespace labmouse
