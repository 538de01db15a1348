// Cells in the order in which the maps and sets of another language list them.
//
// Some programs keep cells in their language's map or set and take the first of several equally good ones as it happens
// to list them. That order is fixed, because so are the hashes, but it is nobody's intention: to walk as such a
// program does, the table has to be built as it is there. These are the tables of Python (CPython on 64 bits) up to
// 3.5; the maps of later ones list their members as they came.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "labmouse/grid/cell.hpp"

namespace labmouse {

/// Whose order: row by row from the south-west, which is neutral, or that of a version of Python.
enum class CellOrder : std::uint8_t { rows, python_2_7, python_3_4, python_3_5 };

/// By their places in CellOrder.
inline constexpr std::array<std::string_view, 4> cell_order_names = {"rows", "python-2.7", "python-3.4", "python-3.5"};
/// The same as the choices of a parameter.
inline constexpr std::string_view all_cell_orders = "rows/python-2.7/python-3.4/python-3.5";
/// The order of that name, which must be one.
CellOrder cell_order(std::string_view name);

/// A map's keys and a set's members lie in tables of different rules.
enum class CellTable : std::uint8_t { map, set };

/// What a program writes for a cell: (row from the north, column) or (column, row from the south).
enum class CellKey : std::uint8_t { row_column, column_row };

/// Open addressing in a table whose length is a power of two. Takes all its memory when made.
class HashedCells {
 public:
  HashedCells(Size size, CellOrder order, CellTable table, CellKey key);

  void insert(Cell cell);
  void erase(Cell cell);
  /// Empties it and forgets how large it had grown.
  void clear();
  /// Becomes a copy, as `set(other)` makes it, of a set that lists these cells in this order.
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
  /// How many slots behind the first are looked at before a search goes elsewhere.
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
