// The built-in failure rates: those of the folder failure_rates/.
#pragma once

#include <span>
#include <string_view>

namespace labmouse {

/// One file of failure_rates/: its name (without the ending) and its text.
struct BuiltinRates {
  std::string_view name;
  std::string_view text;
};

/// All of them, sorted by name.
std::span<const BuiltinRates> builtin_failure_rates();

}  // namespace labmouse
