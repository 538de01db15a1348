// The mazes that the program carries with it: those of the folder mazes/.
#pragma once

#include <span>
#include <string_view>

namespace labmouse {

/// One maze of mazes/: its name (the file's without the ending) and the file's text.
struct BuiltinMaze {
  std::string_view name;
  std::string_view text;
};

/// All of them, sorted by name.
std::span<const BuiltinMaze> builtin_mazes();

}  // namespace labmouse
