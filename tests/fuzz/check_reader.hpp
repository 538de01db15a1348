// What must hold for a reader whatever the bytes are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "labmouse/maze/formats/format.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

/// Reads the bytes as that format: there is a maze or there are problems, and a maze survives being written, and is
/// read as well when the format has to be recognised.
inline void check_reader(const Format& format, const std::uint8_t* bytes, std::size_t size) {
  const std::string_view content(reinterpret_cast<const char*>(bytes), size);
  const ReadResult result = format.read(content);
  require(result.maze.has_value() == result.problems.empty());
  require(result.problems.size() <= most_problems);
  const ReadResult recognised = read_maze(content);
  require(recognised.maze.has_value() == recognised.problems.empty());
  if (!result.maze) return;
  if (recognised_format(content) == &format) require(recognised.maze == result.maze);
  const WriteResult written = format.write(*result.maze);
  // Rectangles of bytes are read, but not written.
  if (written.content) require(format.read(*written.content).maze == result.maze);
}

}  // namespace labmouse::fuzz
