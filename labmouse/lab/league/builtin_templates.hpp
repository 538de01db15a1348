// The robots in Python that are built into the program as a start for others: the files of the folder templates/robots.
#pragma once

#include <span>
#include <string_view>

namespace labmouse {

/// One file of templates/robots: its name (without the ending) and its text.
struct BuiltinTemplate {
  std::string_view name;
  std::string_view text;
};

/// All of them, sorted by name.
std::span<const BuiltinTemplate> builtin_templates();

}  // namespace labmouse
