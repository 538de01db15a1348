// Did my mouse improve? A race against an earlier one on the same mazes.
#pragma once

#include <string>
#include <string_view>

#include "labmouse/lab/tournament.hpp"

namespace labmouse {

/// The comparison as text, or what is wrong with the earlier result: exactly one of the two is there.
struct BaselineResult {
  std::string text;
  std::string error;
};

/// Compares each mouse with the one of the same name in an earlier race's JSON (or the only mouse with the only mouse),
/// maze by maze: mean difference of the penalised scores, new minus old, with its interval over the mazes.
BaselineResult compare_with_baseline(const Race& race, std::string_view earlier_json);

}  // namespace labmouse
