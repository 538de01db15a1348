// Mazes as nested lists: C arrays, JSON, and what Python, NumPy and others print.
#pragma once

#include <string_view>

#include "labmouse/maze/formats/coded_cells.hpp"

namespace labmouse::formats {

/// Whether a text begins with a list or an object, as JSON and NumPy write them, and no declaration.
bool is_json_text(std::string_view content);

/// Reads a list of cells, or of rows or columns of cells. A cell is a number of four bits, four flags, the letters of
/// its sides ("NE"), or an object with its sides (`walls`, or `n`, `e`, `s`, `w`), perhaps with its place (`x`, `y`).
/// A row can also be a string of hexadecimal digits or of blocks.
/// @param format The name for messages. @param usual How the format usual has numbers and flags.
ReadResult read_listed_cells(std::string_view content, std::string_view format, Layout usual);

}  // namespace labmouse::formats
