// Mazes as a picture of characters or a table of numbers: rows of hexadecimal digits, blocks, tables.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "labmouse/maze/formats/coded_cells.hpp"

namespace labmouse::formats {

/// A row of characters, and where it begins.
struct TextRow {
  std::string_view text;
  int line = 0;
  int column = 0;
};

/// The lines of a text as rows; no more than a maze can have.
std::vector<TextRow> text_rows_of(std::string_view content);

/// Whether there are hexadecimal digits only.
bool is_hexadecimal(std::string_view text);

/// Whether the rows are equally long and hold hexadecimal digits only.
bool are_hex_digits(std::span<const TextRow> rows);

/// Whether the rows are equally long and consist of two characters: one is the whole border, and in no middle of a
/// cell.
bool are_blocks(std::span<const TextRow> rows);

/// A hexadecimal digit for each cell; or blocks: (2W+1)x(2H+1) characters, of which the one of the border is a wall.
ReadResult read_text_rows(std::span<const TextRow> rows, std::string_view format);

/// Numbers in rows.
struct NumberTable {
  std::vector<CodedCells::Entry> entries = {};
  int width = 0;  ///< 0 where it is not stated
  Layout usual = Layout::rows_from_north;
};

/// A number for each cell, or blocks of 0 and 1.
ReadResult read_number_table(const NumberTable& table, std::string_view format);

}  // namespace labmouse::formats
