// The board files that are built into the program: the files of the folder boards/. They say to which pins of a chip a
// robot is wired.
#pragma once

#include <span>
#include <string_view>

namespace labmouse {

/// One file of boards/: its name (without the ending) and its text.
struct BuiltinBoard {
  std::string_view name;
  std::string_view text;
};

/// All of them, sorted by name.
std::span<const BuiltinBoard> builtin_boards();

}  // namespace labmouse
