#include "labmouse/body/field.hpp"

namespace labmouse {

Field::Field(const Maze& maze, double cell)
    : size_(maze.size()), cell_(cell), per_cell_(1.0 / cell), half_wall_(half_wall_of(cell)) {
  for (int index = 0; index < size_.area(); ++index) {
    unsigned walls = 0;
    for (const Heading side : all_headings)
      if (!maze.is_open(size_.cell_at(index), side)) walls |= 1U << static_cast<unsigned>(side);
    walls_.push_back(static_cast<std::uint8_t>(walls));
  }
}

}  // namespace labmouse
