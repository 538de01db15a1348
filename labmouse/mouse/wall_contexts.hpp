// What is known about the surroundings of each wall: whether its eight neighbours are unknown, open or closed.
//
// Six meet it at its two posts, two lie beside it. For a wall that runs from left to right (the north side of a cell;
// an east side is looked at with x and y exchanged):
//
//              o   7   o
//              2       5
//          0   o-------o   3
//              1       4
//              o   6   o
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "labmouse/grid/wall.hpp"
#include "labmouse/mouse/knowledge.hpp"

namespace labmouse {

/// A context is a number of eight digits to the base three, the digit of neighbour 0 lowest: 0 unknown, 1 open, 2
/// closed.
inline constexpr int wall_contexts = 6561;

/// The eight neighbours of a wall, in the order of the picture; some may lie on the border or outside.
std::array<Wall, 8> neighbours_of(Wall wall);

/// The smallest of this context and its mirror images, so that walls of symmetric surroundings share it.
int folded_context(int context);

/// The context of a wall, computed from known walls without a WallContexts.
int context_of(Wall wall, const Knowledge& knowledge);

/// The contexts of all walls of a maze, kept up to date as walls become known. The border is closed from the beginning.
class WallContexts {
 public:
  explicit WallContexts(Size size);

  int of(Wall wall) const { return contexts_[index(wall)]; }
  /// Adds the state of a wall to its neighbours' contexts; once for each wall. Calls changed(Wall) for each inner
  /// neighbour.
  template <class Changed>
  void learn(Wall wall, bool open, Changed changed) {
    const std::array<Wall, 8> neighbours = neighbours_of(wall);
    for (unsigned i = 0; i < neighbours.size(); ++i) {
      if (on_border(neighbours[i], size_)) continue;
      add(neighbours[i], position_in_neighbour[i], open ? 1 : 2);
      changed(neighbours[i]);
    }
  }

 private:
  /// A wall's position among the neighbours of its own neighbour i.
  static constexpr std::array<std::uint8_t, 8> position_in_neighbour = {3, 5, 2, 0, 4, 1, 7, 6};
  static constexpr std::array<std::uint16_t, 8> weight = {1, 3, 9, 27, 81, 243, 729, 2187};

  std::size_t index(Wall wall) const {
    return static_cast<std::size_t>(2 * size_.index(wall.cell) + (wall.side == Heading::east ? 1 : 0));
  }
  void add(Wall wall, unsigned position, int digit) {
    contexts_[index(wall)] = static_cast<std::uint16_t>(contexts_[index(wall)] + digit * weight[position]);
  }

  Size size_;
  std::vector<std::uint16_t> contexts_;
};

}  // namespace labmouse
