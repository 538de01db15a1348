// The binary "maz" format: one byte a cell, column by column from the start corner: (0,0), (0,1), ...
//
// Bits 0 to 3 of a byte are the walls north, east, south and west; programs use the others for cells that were seen.
// The size follows from the length.
#include <algorithm>

#include "labmouse/maze/formats/cell_table.hpp"
#include "labmouse/maze/formats/coded_cells.hpp"
#include "labmouse/maze/formats/format.hpp"
#include "labmouse/maze/formats/problem_list.hpp"
#include "labmouse/maze/formats/text.hpp"

namespace labmouse {
namespace {

using namespace formats;

constexpr std::size_t most_bytes_of_maz = max_side * max_side;

unsigned byte_of(char letter) { return static_cast<unsigned char>(letter); }

/// Whether a byte stands in no text: neither ASCII nor UTF-8.
bool is_no_text(char letter) {
  const unsigned byte = byte_of(letter);
  return byte < 9 || (byte > 13 && byte < 32) || byte > 0xF4;
}

bool is_maz(std::string_view content) {
  return content.size() >= 4 && content.size() <= most_bytes_of_maz &&
         std::any_of(content.begin(), content.end(), is_no_text);
}

ReadResult read_maz(std::string_view content) {
  if (content.empty()) return failure(0, 0, "the file is empty");
  if (content.size() > most_bytes_of_maz)
    return failure(0, 0,
                   joined("expected at most ", most_bytes_of_maz, " bytes, one for each cell, found ", content.size()));
  CodedCells cells{.format = "bytes", .usual = Layout::columns_from_west};
  for (std::size_t i = 0; i < content.size(); ++i)
    cells.entries.push_back({byte_of(content[i]), 0, static_cast<int>(i) + 1});
  return maze_of(cells);
}

WriteResult write_maz(const Maze& maze) {
  const auto [width, height] = maze.size();
  if (width != height || width == 1)
    return {std::nullopt,
            joined("the maze has ", width, "x", height, " cells; the maz format holds only squares from 2x2")};
  if (std::string reason = refused_marks(maze); !reason.empty()) return {std::nullopt, std::move(reason)};
  std::string content;
  for (int x = 0; x < width; ++x)
    for (int y = 0; y < height; ++y) content += static_cast<char>(~open_sides(maze, {x, y}) & all_sides);
  return {std::move(content), {}};
}

}  // namespace

constinit const Format maz_format = {
    .name = "maz",
    .summary = "binary, one byte of walls for each cell; squares",
    .extension = ".maz",
    .recognises = is_maz,
    .read = read_maz,
    .write = write_maz,
};

}  // namespace labmouse
