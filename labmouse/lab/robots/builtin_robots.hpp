// The robots built into the program: the files of the folder robots/.
#pragma once

#include <span>
#include <string_view>

namespace labmouse {

/// One robot of robots/: its name (the file's without the ending) and the file's text.
struct BuiltinRobot {
  std::string_view name;
  std::string_view text;
};

/// All of them, sorted by name.
std::span<const BuiltinRobot> builtin_robots();

}  // namespace labmouse
