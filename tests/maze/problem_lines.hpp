// Problems as a person reads them, for tests that compare them with what they should be.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "labmouse/maze/formats/format.hpp"

namespace labmouse::test {

using Lines = std::vector<std::string>;

/// Each problem as "LINE:COLUMN: REASON".
inline Lines lines_of(const ReadResult& result) {
  Lines lines;
  for (const Problem& problem : result.problems)
    lines.push_back(std::to_string(problem.line) + ":" + std::to_string(problem.column) + ": " + problem.reason);
  return lines;
}

/// What a format finds wrong with a content; "a maze" when it reads one.
inline Lines problems_of(const Format& format, std::string_view content) {
  const ReadResult result = format.read(content);
  if (result.maze) return {"a maze"};
  return lines_of(result);
}

/// A drawing as raw strings have it: without the line end behind R"(.
inline std::string_view content_of(std::string_view text) {
  if (text.starts_with('\n')) text.remove_prefix(1);
  return text;
}

/// The maze of a content that must be right.
inline Maze maze_of(const Format& format, std::string_view content) {
  return format.read(content_of(content)).maze.value();
}

}  // namespace labmouse::test
