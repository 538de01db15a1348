// The hazards that the program carries with it: those of the folder hazards/.
#pragma once

#include <span>
#include <string_view>

namespace labmouse {

/// One file of hazards/: its name (without the ending) and its text.
struct BuiltinHazards {
  std::string_view name;
  std::string_view text;
};

/// All of them, sorted by name.
std::span<const BuiltinHazards> builtin_hazards();

}  // namespace labmouse
