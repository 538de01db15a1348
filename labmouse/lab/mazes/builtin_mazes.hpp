// The mazes of the folder mazes/, which are compiled into the program.
#pragma once

#include <span>
#include <string_view>

namespace labmouse {

/// One maze of mazes/: its name (the file's without the ending) and the file's text.
struct BuiltinMaze {
  std::string_view name;
  std::string_view text;
};

/// All built-in mazes, sorted by name.
std::span<const BuiltinMaze> builtin_mazes();

}  // namespace labmouse
