// A set of cells that keeps them in the order of a hash table.
//
// Some programs keep cells in their language's map and take the first of several equally good ones as the map happens
// to list them. That order is fixed, because so are the hashes, but it is nobody's intention: to walk as such a
// program does, the table has to be built as it is there. This is the map of Python on 64 bits, up to 3.5; later ones
// list their members as they came.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "labmouse/grid/cell.hpp"

namespace labmouse {

/// The versions of the language that differ in when and how far a table grows.
enum class Python : std::uint8_t { v2_7, v3_5 };

/// What a program writes for a cell: (row from the north, column) or (column, row from the south).
enum class CellKey : std::uint8_t { row_column, column_row };

/// Open addressing in a table whose length is a power of two. Takes all its memory when made.
class HashedCells {
 public:
  HashedCells(Size size, Python version, CellKey key);

  void insert(Cell cell);
  void erase(Cell cell);
  /// Empties it and forgets how large it had grown.
  void clear();

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
  /// The slot that holds the cell, or the one in which it belongs.
  Slot& slot_of(Cell cell);
  bool make_room_before();
  void make_room_after();
  void rebuild(std::size_t length);

  Size size_;
  Python version_;
  CellKey key_;
  std::size_t mask_ = 0;
  std::size_t members_ = 0;
  std::size_t used_ = 0;
  std::vector<Slot> slots_;
  std::vector<Slot> old_slots_;
};

}  // namespace labmouse
