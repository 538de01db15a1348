// Tables of cells whose sides are coded in a way that the file does not state: which bit is which side, whether a bit
// is a wall or an opening, and in which order the cells stand.
//
// All ways are tried. Those remain whose walls agree from both sides and whose border is closed.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/maze/formats/read_result.hpp"

namespace labmouse::formats {

/// How the entries of a table lie in the maze.
enum class Layout : std::uint8_t { rows_from_north, rows_from_south, columns_from_west, columns_from_east };

/// A table of cells, as rows of entries.
struct CodedCells {
  enum class Code : std::uint8_t {
    number,   ///< some four bits are the sides; the other bits do not count
    flags,    ///< bit i is the i-th of four flags, in an order that is not stated
    letters,  ///< bits 0 to 3 are north, east, south and west
  };

  struct Entry {
    unsigned value = 0;
    int line = 0;
    int column = 0;
  };

  std::string_view format;  ///< such as "C array", for messages
  Code code = Code::number;
  /// How the format usually has its cells; a number is then 1 north, 2 east, 4 south and 8 west, all of them walls.
  Layout usual = Layout::rows_from_north;
  std::vector<Entry> entries = {};  ///< row by row, at most 4096
  /// The entries of a row; 0 where the file does not state it, so that all sizes are tried, a square before others.
  int width = 0;
};

/// The maze of the table. If several ways fit, it prefers in this order: the usual way of the format; a way in a layout
/// that programs use, with the usual start, which is open to the north only; a way in such a layout with the bits
/// north, east, south and west. A note says how many other mazes with the usual start there are. If no way fits, the
/// result has the problems of the usual way.
ReadResult maze_of(const CodedCells& cells);

}  // namespace labmouse::formats
