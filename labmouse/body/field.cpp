#include "labmouse/body/field.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace labmouse {

Field::Field(const Maze& maze, double cell, std::vector<Position> post_shifts)
    : size_(maze.size()),
      cell_(cell),
      per_cell_(1.0 / cell),
      half_wall_(half_wall_of(cell)),
      post_shifts_(std::move(post_shifts)) {
  for (const Position& shift : post_shifts_)
    most_shift_ = std::max({most_shift_, std::abs(shift.x), std::abs(shift.y)});
  for (int index = 0; index < size_.area(); ++index) {
    unsigned walls = 0;
    for (const Heading side : all_headings)
      if (!maze.is_open(size_.cell_at(index), side)) walls |= 1U << static_cast<unsigned>(side);
    walls_.push_back(static_cast<std::uint8_t>(walls));
  }
}

double Field::upright_shift(int line, double y) const {
  if (post_shifts_.empty()) return 0.0;
  const int row = index_at(y);
  const double part = y * per_cell_ - row;
  return (1.0 - part) * post_shift(line, row).x + part * post_shift(line, row + 1).x;
}

double Field::level_shift(double x, int line) const {
  if (post_shifts_.empty()) return 0.0;
  const int column = index_at(x);
  const double part = x * per_cell_ - column;
  return (1.0 - part) * post_shift(column, line).y + part * post_shift(column + 1, line).y;
}

}  // namespace labmouse
