// The price of passing each wall: 0 if it is open, a strategy's guess if it has not been seen; closed walls are
// impassable.
#pragma once

#include <cassert>
#include <cstdint>
#include <vector>

#include "labmouse/grid/wall.hpp"

namespace labmouse {

/// A price for each wall of a maze, 0 to highest, or closed; the border is closed. Takes all its memory when made.
class WallPrices {
 public:
  static constexpr int highest = 250;  ///< the largest price of a wall that can be passed
  static constexpr int closed = 255;   ///< the price of a wall that cannot

  /// All walls closed.
  /// @param size of the maze, with sides of 1 to max_side cells.
  explicit WallPrices(Size size)
      : size_(size),
        north_(static_cast<std::size_t>(size.width + size.area()), closed),
        east_(static_cast<std::size_t>(1 + size.area()), closed) {}

  /// The size of the maze.
  Size size() const { return size_; }
  /// The price of a wall.
  /// @param wall an inner one, or one of the border, which is closed.
  /// @return 0 to `highest`, or `closed`.
  int of(Wall wall) const { return sides(wall)[size_.index(wall.cell)]; }
  /// Whether a wall is not closed.
  /// @param wall an inner one, or one of the border, which is closed.
  bool passable(Wall wall) const { return of(wall) != closed; }
  /// Sets the price of a wall.
  /// @param wall an inner one.
  /// @param price 0 to `highest`, or `closed`.
  void set(Wall wall, int price) {
    assert(!on_border(wall, size_) && (price == closed || (price >= 0 && price <= highest)));
    const auto index = static_cast<std::size_t>(size_.index(wall.cell));
    (wall.side == Heading::north ? north_[index + static_cast<unsigned>(size_.width)] : east_[index + 1]) =
        static_cast<std::uint8_t>(price);
  }

  /// Prices of the north sides by the cell's index. The entries before the first are closed, so that a search can read
  /// the south side of any cell, north()[index - width]. Valid as long as this object.
  const std::uint8_t* north() const { return north_.data() + size_.width; }
  /// Prices of the east sides by the cell's index. The entry before the first is closed, so that a search can read the
  /// west side of any cell, east()[index - 1]. Valid as long as this object.
  const std::uint8_t* east() const { return east_.data() + 1; }

 private:
  const std::uint8_t* sides(Wall wall) const { return wall.side == Heading::north ? north() : east(); }

  Size size_;
  std::vector<std::uint8_t> north_;
  std::vector<std::uint8_t> east_;
};

}  // namespace labmouse
