// A maze as boxes, worked out from its walls alone: what tests of beams and touches go by.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "labmouse/functions/position.hpp"
#include "labmouse/maze/maze.hpp"
#include "tests/body/plain_mouse.hpp"

namespace labmouse::test {

inline constexpr double half_wall = cell / 30.0;

/// The maze as the sum of its boxes, worked out from its walls alone.
class Boxes {
 public:
  struct Box {
    double west, south, east, north;
  };

  explicit Boxes(const Maze& maze) : maze_(maze) {
    const Size size = maze.size();
    for (int x = 0; x <= size.width; ++x)
      for (int y = 0; y <= size.height; ++y) {
        add(x * cell, y * cell, 0.0, 0.0);
        if (y < size.height && stands(x, y, true)) add(x * cell, y * cell, 0.0, cell);
        if (x < size.width && stands(x, y, false)) add(x * cell, y * cell, cell, 0.0);
      }
  }

  /// Whether the wall between two cells of a row (or of a column) stands.
  bool stands(int x, int y, bool upright) const {
    const Size size = maze_.size();
    if (upright) return x == 0 || x == size.width || !maze_.is_open({x - 1, y}, Heading::east);
    return y == 0 || y == size.height || !maze_.is_open({x, y - 1}, Heading::north);
  }
  /// Whether that place of a line, in mm from its beginning, lies on a wall or a post.
  bool covers(int line, double place, bool upright) const {
    const Size size = maze_.size();
    const int cells = upright ? size.height : size.width;
    const int nearest = static_cast<int>(std::lround(place / cell));
    if (nearest >= 0 && nearest <= cells && std::abs(place - nearest * cell) < half_wall) return true;
    const int along = static_cast<int>(std::floor(place / cell));
    if (along < 0 || along >= cells) return false;
    return upright ? stands(line, along, true) : stands(along, line, false);
  }
  const std::vector<Box>& all() const { return boxes_; }
  bool inside(const Position& at) const {
    return std::any_of(boxes_.begin(), boxes_.end(), [&](const Box& box) {
      return at.x > box.west && at.x < box.east && at.y > box.south && at.y < box.north;
    });
  }
  /// Only those that come so near.
  Boxes near(const Position& at, double reach) const {
    Boxes some = *this;
    std::erase_if(some.boxes_, [&](const Box& box) {
      return at.x + reach < box.west || at.x - reach > box.east || at.y + reach < box.south || at.y - reach > box.north;
    });
    return some;
  }

 private:
  void add(double x, double y, double width, double height) {
    boxes_.push_back({x - half_wall, y - half_wall, x + width + half_wall, y + height + half_wall});
  }

  const Maze& maze_;
  std::vector<Box> boxes_;
};

}  // namespace labmouse::test
