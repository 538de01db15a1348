// Sets of cells that are listed in the order of Python's hash tables.
//
// Some programs keep cells in a map or a set of Python, and take the first of several equally good ones in the order of
// that table. The order is fixed, because the hashes are. To reproduce the moves of such a program, these tables are
// built in the same way. They are those of CPython on 64 bits up to 3.5; later maps list their members in order of
// insertion.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "labmouse/grid/cell.hpp"

namespace labmouse {

/// An order of listing: row by row from the south-west, which is neutral, or that of a version of Python.
enum class CellOrder : std::uint8_t { rows, python_2_7, python_3_4, python_3_5 };

/// Names, indexed by CellOrder.
inline constexpr std::array<std::string_view, 4> cell_order_names = {"rows", "python-2.7", "python-3.4", "python-3.5"};
/// The same names as the choices of a parameter.
inline constexpr std::string_view all_cell_orders = "rows/python-2.7/python-3.4/python-3.5";
/// The order of that name, which must be one.
CellOrder cell_order(std::string_view name);

/// Whether the cells are keys of a map or members of a set; their tables follow different rules.
enum class CellTable : std::uint8_t { map, set };

/// The pair that stands for a cell: (row from the north, column) or (column, row from the south).
enum class CellKey : std::uint8_t { row_column, column_row };

/// A hash table of cells with open addressing; its length is a power of two. Takes all its memory when made.
class HashedCells {
 public:
  HashedCells(Size size, CellOrder order, CellTable table, CellKey key);

  void insert(Cell cell);
  void erase(Cell cell);
  /// Empties it and resets its length.
  void clear();
  /// Becomes the copy that Python's `set(other)` makes of a set that lists these cells in this order.
  void copy(std::span<const Cell> other);

  /// Calls visit(Cell) for each member in the order of the table.
  template <class Visit>
  void for_each(Visit visit) const {
    for (std::size_t i = 0; i <= mask_; ++i)
      if (slots_[i].state == State::taken) visit(slots_[i].cell);
  }

 private:
  /// An erased member leaves its slot used: searches for others go on behind it.
  enum class State : std::uint8_t { never_used, taken, erased };
  struct Slot {
    Cell cell;
    State state = State::never_used;
  };

  std::uint64_t hash(Cell cell) const;
  /// Number of slots that are probed in a row before the probe sequence jumps.
  std::uint64_t neighbours(std::uint64_t slot) const;
  /// The slot that holds the cell, or the one in which it belongs.
  Slot& slot_of(Cell cell);
  bool make_room_before();
  void make_room_after();
  void rebuild(std::size_t length);

  Size size_;
  CellOrder order_;
  CellTable table_;
  CellKey key_;
  std::size_t mask_ = 0;
  std::size_t members_ = 0;
  std::size_t used_ = 0;
  std::vector<Slot> slots_;
  std::vector<Slot> old_slots_;
};

}  // namespace labmouse
