// Sets of cells as rows of bits: bit x of word y is cell (x,y).
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "labmouse/grid/cell.hpp"
#include "labmouse/grid/heading.hpp"

namespace labmouse {

/// A set of cells with coordinates 0 to 63. Cells outside are never members; asking for one is fine, inserting is not.
class CellSet {
 public:
  constexpr CellSet() = default;

  /// The set of one cell.
  /// @param cell with coordinates 0 to 63.
  static constexpr CellSet of(Cell cell) {
    CellSet cells;
    cells.insert(cell);
    return cells;
  }

  /// All cells of a maze.
  /// @param size with sides of 1 to max_side.
  static constexpr CellSet all(Size size) {
    CellSet cells;
    const std::uint64_t row = ~std::uint64_t{0} >> (max_side - size.width);
    for (int y = 0; y < size.height; ++y) cells.rows_[static_cast<unsigned>(y)] = row;
    return cells;
  }

  /// Whether a cell is a member.
  /// @param cell any cell; false for those outside of 0 to 63.
  constexpr bool contains(Cell cell) const {
    if (cell.x < 0 || cell.y < 0 || cell.x >= max_side || cell.y >= max_side) return false;
    return (row(cell.y) >> cell.x & 1U) != 0;
  }
  /// Adds a cell.
  /// @param cell with coordinates 0 to 63.
  constexpr void insert(Cell cell) { rows_[static_cast<unsigned>(cell.y)] |= bit(cell); }
  /// Removes a cell, if it is a member.
  /// @param cell with coordinates 0 to 63.
  constexpr void erase(Cell cell) { rows_[static_cast<unsigned>(cell.y)] &= ~bit(cell); }

  /// One row.
  /// @param y 0 to 63.
  /// @return bit x is set if (x,y) is a member.
  constexpr std::uint64_t row(int y) const { return rows_[static_cast<unsigned>(y)]; }
  /// All 64 rows, the southernmost first.
  constexpr const std::uint64_t* rows() const { return rows_.data(); }
  /// Replaces one row.
  /// @param y 0 to 63.
  /// @param bits bit x says whether (x,y) is a member.
  constexpr void set_row(int y, std::uint64_t bits) { rows_[static_cast<unsigned>(y)] = bits; }

  /// Whether the set has no members.
  constexpr bool empty() const {
    for (const auto bits : rows_)
      if (bits != 0) return false;
    return true;
  }
  /// The number of members.
  constexpr int count() const {
    int cells = 0;
    for (const auto bits : rows_) cells += std::popcount(bits);
    return cells;
  }

  /// Adds the cells of the other set.
  constexpr CellSet& operator|=(const CellSet& other) {
    for (unsigned y = 0; y < rows_.size(); ++y) rows_[y] |= other.rows_[y];
    return *this;
  }
  /// Keeps only the cells that are also in the other set.
  constexpr CellSet& operator&=(const CellSet& other) {
    for (unsigned y = 0; y < rows_.size(); ++y) rows_[y] &= other.rows_[y];
    return *this;
  }
  /// Removes the cells of the other set.
  constexpr CellSet& operator-=(const CellSet& other) {
    for (unsigned y = 0; y < rows_.size(); ++y) rows_[y] &= ~other.rows_[y];
    return *this;
  }
  friend constexpr bool operator==(const CellSet&, const CellSet&) = default;

  /// Visits the members in the total order of cells.
  /// @param visit called as visit(Cell) for each.
  template <class Visit>
  constexpr void for_each(Visit visit) const {
    for (int y = 0; y < max_side; ++y)
      for (std::uint64_t bits = row(y); bits != 0; bits &= bits - 1) visit(Cell{std::countr_zero(bits), y});
  }

 private:
  static constexpr std::uint64_t bit(Cell cell) { return std::uint64_t{1} << cell.x; }

  std::array<std::uint64_t, max_side> rows_{};
};

}  // namespace labmouse
