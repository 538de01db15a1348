#include "labmouse/maze/formats/text_rows.hpp"

#include <algorithm>

#include "labmouse/functions/parse_number.hpp"
#include "labmouse/maze/formats/problem_list.hpp"
#include "labmouse/maze/formats/text.hpp"

namespace labmouse::formats {
namespace {

/// Blocks as numbers, row by row: 1 is a wall.
struct Blocks {
  Size size;  ///< in blocks
  std::vector<CodedCells::Entry> entries = {};

  const CodedCells::Entry& at(int row, int column) const {
    return entries[static_cast<unsigned>(row * size.width + column)];
  }
};

bool is_size_of_blocks(Size size) {
  return size.width % 2 == 1 && size.height % 2 == 1 && size.width >= 3 && size.height >= 3 &&
         size.width <= 2 * max_side + 1 && size.height <= 2 * max_side + 1;
}

/// Whether all blocks of the border are the same and those in the middle of cells are not.
bool are_blocks(const Blocks& blocks) {
  if (!is_size_of_blocks(blocks.size)) return false;
  const unsigned wall = blocks.at(0, 0).value;
  for (int row = 0; row < blocks.size.height; ++row)
    for (int column = 0; column < blocks.size.width; ++column) {
      const bool border = row == 0 || column == 0 || row == blocks.size.height - 1 || column == blocks.size.width - 1;
      const bool cell = row % 2 == 1 && column % 2 == 1;
      const unsigned value = blocks.at(row, column).value;
      if (value > 1 || (border && value != wall) || (cell && value == wall)) return false;
    }
  return true;
}

ReadResult maze_of(const Blocks& blocks, std::string_view format) {
  const Size size{blocks.size.width / 2, blocks.size.height / 2};
  const unsigned wall = blocks.at(0, 0).value;
  MazeDraft draft(size, MazeDraft::Inside::open);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const int row = blocks.size.height - 2 - 2 * y, column = 2 * x + 1;
      if (blocks.at(row, column + 1).value == wall) draft.close({x, y}, Heading::east);
      if (blocks.at(row - 1, column).value == wall) draft.close({x, y}, Heading::north);
    }
  ReadResult result{.maze = Maze(draft)};
  result.reading = joined(format, ", ", size.width, "x", size.height, ", blocks");
  return result;
}

/// Blocks of characters: the one in the corner is the wall, and there is one other.
Blocks blocks_of(std::span<const TextRow> rows) {
  Blocks blocks{.size = {static_cast<int>(rows.front().text.size()), static_cast<int>(rows.size())}};
  if (!is_size_of_blocks(blocks.size)) return {};
  const char wall = rows.front().text.front();
  char other = wall;
  for (const TextRow& row : rows)
    for (std::size_t i = 0; i < row.text.size(); ++i) {
      if (row.text[i] != wall && other == wall) other = row.text[i];
      const unsigned value = row.text[i] == wall ? 1U : row.text[i] == other ? 0U : 2U;
      blocks.entries.push_back({value, row.line, row.column + static_cast<int>(i)});
    }
  return blocks;
}

bool have_one_length(std::span<const TextRow> rows) {
  return !rows.empty() && !rows.front().text.empty() && std::all_of(rows.begin(), rows.end(), [&](const TextRow& row) {
    return row.text.size() == rows.front().text.size();
  });
}

}  // namespace

std::vector<TextRow> text_rows_of(std::string_view content) {
  std::vector<TextRow> rows;
  for (const Line& line : lines_of(content, 2 * max_side + 2)) rows.push_back({line.text, line.number, 1});
  return rows;
}

bool is_hexadecimal(std::string_view text) {
  return text.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
}

bool are_hex_digits(std::span<const TextRow> rows) {
  return have_one_length(rows) && rows.size() <= max_side && rows.front().text.size() <= max_side &&
         std::all_of(rows.begin(), rows.end(), [](const TextRow& row) { return is_hexadecimal(row.text); });
}

bool are_blocks(std::span<const TextRow> rows) { return have_one_length(rows) && are_blocks(blocks_of(rows)); }

ReadResult read_text_rows(std::span<const TextRow> rows, std::string_view format) {
  if (rows.empty()) return failure(0, 0, "there are no rows");
  for (const TextRow& row : rows)
    if (row.text.empty() || row.text.size() != rows.front().text.size())
      return failure(
          row.line, row.column,
          joined("the row has ", row.text.size(), " characters, the first one has ", rows.front().text.size()));
  if (const Blocks blocks = blocks_of(rows); are_blocks(blocks)) return maze_of(blocks, format);
  if (!is_hexadecimal(rows.front().text.substr(0, 1)))
    return failure(
        rows.front().line, rows.front().column,
        joined("blocks need an odd number of rows and columns, one character for walls all along the border, and "
               "another one in each cell; found ",
               rows.front().text.size(), "x", rows.size(), " characters"));
  CodedCells cells{.format = format, .width = static_cast<int>(rows.front().text.size())};
  if (rows.size() > max_side || cells.width > max_side)
    return failure(rows.front().line, rows.front().column,
                   joined(cells.width, "x", rows.size(), " cells; a maze has at most ", max_side, "x", max_side));
  for (const TextRow& row : rows)
    for (std::size_t i = 0; i < row.text.size(); ++i) {
      const int column = row.column + static_cast<int>(i);
      const auto value = parse_whole<unsigned>(row.text.substr(i, 1), 16);
      if (!value)
        return failure(row.line, column, "expected a hexadecimal digit, found " + quoted(row.text.substr(i, 1)));
      cells.entries.push_back({*value, row.line, column});
    }
  return maze_of(cells);
}

ReadResult read_number_table(const NumberTable& table, std::string_view format) {
  const int count = static_cast<int>(table.entries.size());
  for (int width = 3; width <= 2 * max_side + 1 && count > 0; width += 2) {
    const bool fits = table.width == 0 ? width * width == count : width == table.width;
    if (!fits) continue;
    if (const Blocks blocks{{width, count / width}, table.entries}; are_blocks(blocks)) return maze_of(blocks, format);
  }
  if (count == 0 || count > max_side * max_side || table.width > max_side)
    return failure(0, 0, joined(count, " numbers are no maze of 1x1 to ", max_side, "x", max_side, " cells"));
  return maze_of(CodedCells{.format = format, .usual = table.usual, .entries = table.entries, .width = table.width});
}

}  // namespace labmouse::formats
