// Sets of walls, for the true maze and for what a mouse knows of it.
#pragma once

#include "labmouse/grid/cell_set.hpp"
#include "labmouse/grid/wall.hpp"

namespace labmouse {

/// A set of inner walls (those between two cells of a maze), each kept once under its one name.
/// Border walls are never members: they are always closed and every mouse knows them, so a set of open, known or
/// unknown walls needs none of them.
class WallSet {
 public:
  constexpr WallSet() = default;

  /// All inner walls of a maze.
  /// @param size with sides of 1 to max_side.
  static constexpr WallSet all(Size size) {
    WallSet walls;
    if (size.height > 1) walls.north_ = CellSet::all({size.width, size.height - 1});
    if (size.width > 1) walls.east_ = CellSet::all({size.width - 1, size.height});
    return walls;
  }

  /// The walls on the north sides of some cells and on the east sides of others.
  /// @param north cells whose north sides are inner walls.
  /// @param east cells whose east sides are inner walls.
  static constexpr WallSet of(const CellSet& north, const CellSet& east) {
    WallSet walls;
    walls.north_ = north;
    walls.east_ = east;
    return walls;
  }

  /// Whether a wall is a member.
  /// @param wall as wall_at() makes it; false for those of the border.
  constexpr bool contains(Wall wall) const { return side(wall).contains(wall.cell); }
  /// Adds a wall.
  /// @param wall an inner one, as wall_at() makes it.
  constexpr void insert(Wall wall) { side(wall).insert(wall.cell); }
  /// Removes a wall, if it is a member.
  /// @param wall an inner one, as wall_at() makes it.
  constexpr void erase(Wall wall) { side(wall).erase(wall.cell); }

  /// The cells whose north side is in the set.
  constexpr const CellSet& north() const { return north_; }
  /// The cells whose east side is in the set.
  constexpr const CellSet& east() const { return east_; }

  /// Whether the set has no members.
  constexpr bool empty() const { return north_.empty() && east_.empty(); }
  /// The number of members.
  constexpr int count() const { return north_.count() + east_.count(); }

  /// Adds the walls of the other set.
  constexpr WallSet& operator|=(const WallSet& other) {
    north_ |= other.north_;
    east_ |= other.east_;
    return *this;
  }
  /// Removes the walls of the other set.
  constexpr WallSet& operator-=(const WallSet& other) {
    north_ -= other.north_;
    east_ -= other.east_;
    return *this;
  }
  friend constexpr bool operator==(const WallSet&, const WallSet&) = default;

  /// Visits the members in a fixed order: all north sides, then all east sides, each in the total order of cells.
  /// @param visit called as visit(Wall) for each.
  template <class Visit>
  constexpr void for_each(Visit visit) const {
    north_.for_each([&](Cell cell) { visit(Wall{cell, Heading::north}); });
    east_.for_each([&](Cell cell) { visit(Wall{cell, Heading::east}); });
  }

 private:
  constexpr CellSet& side(Wall wall) { return wall.side == Heading::north ? north_ : east_; }
  constexpr const CellSet& side(Wall wall) const { return wall.side == Heading::north ? north_ : east_; }

  CellSet north_;
  CellSet east_;
};

}  // namespace labmouse
