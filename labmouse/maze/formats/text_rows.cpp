#include "labmouse/maze/formats/text_rows.hpp"

#include <algorithm>

#include "labmouse/functions/parse_number.hpp"
#include "labmouse/maze/formats/cell_table.hpp"
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

/// The openings in the border, which lie beside cells; nothing if these are no blocks: those of the border are the same
/// but for a few openings, and those in the middle of cells are others.
std::optional<std::vector<BorderGap>> gaps_of(const Blocks& blocks) {
  if (!is_size_of_blocks(blocks.size)) return std::nullopt;
  const unsigned wall = blocks.at(0, 0).value;
  const int east = blocks.size.width - 1, south = blocks.size.height - 1;
  std::vector<BorderGap> gaps;
  for (int row = 0; row <= south; ++row)
    for (int column = 0; column <= east; ++column) {
      const bool border = row == 0 || column == 0 || row == south || column == east;
      const bool cell = row % 2 == 1 && column % 2 == 1;
      const unsigned value = blocks.at(row, column).value;
      if (value > 1 || (cell && value == wall)) return std::nullopt;
      if (!border || value == wall) continue;
      if (row % 2 == column % 2) return std::nullopt;  // a post
      const Heading side = row == 0         ? Heading::north
                           : column == east ? Heading::east
                           : row == south   ? Heading::south
                                            : Heading::west;
      gaps.push_back({{std::min(column / 2, east / 2 - 1), std::min((south - row) / 2, south / 2 - 1)}, side});
    }
  const bool closes = gaps.size() <= most_gaps && (east / 2) * (south / 2) >= least_cells_with_gaps;
  return gaps.empty() || closes ? std::optional(gaps) : std::nullopt;
}

ReadResult maze_of(const Blocks& blocks, std::vector<BorderGap> gaps, std::string_view format) {
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
  result.gaps = std::move(gaps);
  return result;
}

/// Blocks of characters: the one in the corner is the wall, and there is one other. A row may lack its trailing blanks.
Blocks blocks_of(std::span<const TextRow> rows) {
  std::size_t width = 0;
  for (const TextRow& row : rows) width = std::max(width, row.text.size());
  Blocks blocks{.size = {static_cast<int>(width), static_cast<int>(rows.size())}};
  if (!is_size_of_blocks(blocks.size) || rows.front().text.empty()) return {};
  const char wall = rows.front().text.front();
  char other = wall;
  for (const TextRow& row : rows)
    for (std::size_t i = 0; i < width; ++i) {
      const char letter = i < row.text.size() ? row.text[i] : ' ';
      if (letter != wall && other == wall) other = letter;
      const unsigned value = letter == wall ? 1U : letter == other ? 0U : 2U;
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

bool are_blocks(std::span<const TextRow> rows) { return gaps_of(blocks_of(rows)).has_value(); }

ReadResult read_text_rows(std::span<const TextRow> rows, std::string_view format) {
  if (rows.empty()) return failure(0, 0, "there are no rows");
  const Blocks blocks = blocks_of(rows);
  if (auto gaps = gaps_of(blocks)) return maze_of(blocks, std::move(*gaps), format);
  for (const TextRow& row : rows)
    if (row.text.empty() || row.text.size() != rows.front().text.size())
      return failure(
          row.line, row.column,
          joined("the row has ", row.text.size(), " characters, the first one has ", rows.front().text.size()));
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
    const Blocks blocks{{width, count / width}, table.entries};
    if (auto gaps = gaps_of(blocks)) return maze_of(blocks, std::move(*gaps), format);
  }
  if (count == 0 || count > max_side * max_side || table.width > max_side)
    return failure(0, 0, joined(count, " numbers are no maze of 1x1 to ", max_side, "x", max_side, " cells"));
  return maze_of(CodedCells{.format = format, .usual = table.usual, .entries = table.entries, .width = table.width});
}

}  // namespace labmouse::formats
