// The figures of a contest (the values that its world reports besides the score) as text, without loss, for any world.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/races/value.hpp"

namespace labmouse {

/// A JSON list. Numbers have as many digits as needed, real ones with a point or an exponent. Other values: [] for
/// none, {"json": "..."} for a figure that is JSON itself, {"real": "nan"} and {"bytes": "..."} for values that JSON
/// cannot express.
std::string figures_text(std::span<const Value> figures);

/// Reads the text of figures_text(); nothing where it is invalid.
std::optional<std::vector<Value>> read_figures(std::string_view text);

}  // namespace labmouse
