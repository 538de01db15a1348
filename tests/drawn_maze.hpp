// Mazes that a person can see: drawings in raw strings, indented as the code around them.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>

#include "labmouse/maze/formats/format.hpp"

namespace labmouse::test {

/// The lines of a raw string without its first, empty one, and without the blanks that all of them begin with.
inline std::string unindented(std::string_view text) {
  if (!text.empty() && text.front() == '\n') text.remove_prefix(1);
  const std::size_t indent = std::min(text.find_first_not_of(' '), text.size());
  std::string lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    if (line.find_first_not_of(' ') != std::string_view::npos) lines += std::string(line.substr(indent)) + "\n";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// The maze of a drawing; a bad drawing is a mistake in the test and ends it.
inline Maze drawn(std::string_view drawing) {
  const ReadResult read = drawing_format.read(unindented(drawing));
  if (!read.maze) {
    for (const Problem& problem : read.problems)
      std::cerr << "row " << problem.line << ", column " << problem.column << ": " << problem.reason << '\n';
    std::abort();
  }
  return *read.maze;
}

/// A ring of eight cells, with the goal in its middle on the right.
inline const Maze& ring() {
  static const Maze maze = drawn(R"(
    o---o---o---o
    |           |
    o   o---o   o
    |   |   | G |
    o   o---o   o
    | S |       |
    o---o---o---o
  )");
  return maze;
}

}  // namespace labmouse::test
