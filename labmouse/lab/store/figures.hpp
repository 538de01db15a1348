// The figures of a contest as text that gives them back exactly, whatever world they are of.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/races/value.hpp"

namespace labmouse {

/// A list of JSON: numbers with as many digits as they need, real ones with a point or an exponent; [] for no value,
/// {"json": "..."} for JSON as its world wrote it, {"real": "nan"} and {"bytes": "..."} for what JSON cannot say.
std::string figures_text(std::span<const Value> figures);

/// What figures_text wrote; nothing where a text is no such list.
std::optional<std::vector<Value>> read_figures(std::string_view text);

}  // namespace labmouse
