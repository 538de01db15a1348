// The binary "maz" format: one byte a cell, column by column from the start corner: (0,0), (0,1), ...
//
// Bits 0 to 3 of a byte are the walls north, east, south and west; the others are 0. The size follows from the length.
#include <algorithm>

#include "labmouse/maze/formats/cell_table.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/maze/formats/problem_list.hpp"

namespace labmouse {
namespace {

using namespace formats;

// The side of the square, or 0 when no maz file has that length.
int side_of(std::size_t bytes) {
  if (bytes == 16 * 16) return 16;
  if (bytes == 32 * 32) return 32;
  return 0;
}

unsigned byte_of(char letter) { return static_cast<unsigned char>(letter); }

bool is_maz(std::string_view content) {
  return side_of(content.size()) != 0 &&
         std::all_of(content.begin(), content.end(), [](char letter) { return byte_of(letter) <= all_sides; });
}

ReadResult read_maz(std::string_view content) {
  if (content.empty()) return failure(0, 0, "the file is empty");
  const int side = side_of(content.size());
  if (side == 0)
    return failure(0, 0, "expected 256 bytes (16x16) or 1024 bytes (32x32), found " + std::to_string(content.size()));
  std::vector<CellStatement> statements;
  ProblemList problems;
  for (int i = 0; i < side * side; ++i) {
    const unsigned walls = byte_of(content[static_cast<unsigned>(i)]);
    if (walls > all_sides) problems.add(0, i + 1, "expected a byte from 0 to 15, found " + std::to_string(walls));
    statements.push_back({{i / side, i % side}, ~walls & all_sides, 0, i + 1});
  }
  if (!problems.empty()) return problems.failure();
  return maze_of({side, side}, statements);
}

WriteResult write_maz(const Maze& maze) {
  const auto [width, height] = maze.size();
  if (width != height || side_of(static_cast<std::size_t>(maze.size().area())) == 0)
    return {std::nullopt, "the maze has " + std::to_string(width) + "x" + std::to_string(height) +
                              " cells; the maz format holds only 16x16 and 32x32"};
  if (std::string reason = refused_marks(maze); !reason.empty()) return {std::nullopt, std::move(reason)};
  std::string content;
  for (int x = 0; x < width; ++x)
    for (int y = 0; y < height; ++y) content += static_cast<char>(~open_sides(maze, {x, y}) & all_sides);
  return {std::move(content), {}};
}

}  // namespace

constinit const Format maz_format = {
    .name = "maz",
    .summary = "binary, one byte of walls for each cell; 16x16 or 32x32",
    .recognises = is_maz,
    .read = read_maz,
    .write = write_maz,
};

}  // namespace labmouse
