// The rules of contests in seconds that are built into the program: the files of the folder rules/.
#pragma once

#include <span>
#include <string_view>

namespace labmouse {

/// One file of rules/: its name (without the ending) and its text.
struct BuiltinRules {
  std::string_view name;
  std::string_view text;
};

/// All of them, sorted by name.
std::span<const BuiltinRules> builtin_rules();

}  // namespace labmouse
