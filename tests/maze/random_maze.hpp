// Random mazes for property tests; a failing one is shown as a drawing.
#pragma once

#include <rapidcheck.h>

#include <ostream>

#include "labmouse/chance/rng.hpp"
#include "labmouse/maze/formats/format.hpp"

namespace labmouse {

inline void showValue(const Maze& maze, std::ostream& out) {
  out << '\n' << drawing_format.write(maze.with_start(maze.start(), Heading::north)).content.value_or("(no drawing)\n");
}

}  // namespace labmouse

namespace labmouse::test {

/// A maze of that size in which each inner wall is open with a chance of `share` in eight.
inline Maze random_maze(Size size, std::uint64_t seed, int share) {
  Rng rng(seed);
  MazeDraft draft(size, MazeDraft::Inside::closed);
  for (int i = 0; i < size.area(); ++i) {
    if (rng.chance(share, 8)) draft.open(size.cell_at(i), Heading::north);
    if (rng.chance(share, 8)) draft.open(size.cell_at(i), Heading::east);
  }
  return Maze(draft);
}

/// Sizes from 1×1 to 64×64; they shrink towards 1×1.
inline rc::Gen<Size> sizes() {
  // Whatever the size parameter of RapidCheck, large mazes come as often as small ones.
  const auto side = rc::gen::resize(rc::kNominalSize, rc::gen::inRange(1, max_side + 1));
  return rc::gen::construct<Size>(side, side);
}

/// Random mazes of a size with the default start and goals, from closed to empty.
inline rc::Gen<Maze> mazes_of(rc::Gen<Size> size) {
  return rc::gen::apply(random_maze, size, rc::gen::arbitrary<std::uint64_t>(), rc::gen::inRange(0, 9));
}

/// Random cells of a size.
inline rc::Gen<Cell> cells_of(Size size) {
  return rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, size.area())),
                      [size](int index) { return size.cell_at(index); });
}

/// Random mazes of all sizes with a start and one to five goals anywhere.
inline rc::Gen<Maze> marked_mazes() {
  return rc::gen::mapcat(mazes_of(sizes()), [](const Maze& maze) {
    const auto cells =
        rc::gen::resize(5, rc::gen::nonEmpty(rc::gen::container<std::vector<Cell>>(cells_of(maze.size()))));
    return rc::gen::apply(
        [maze](Cell start, Heading heading, const std::vector<Cell>& goals) {
          CellSet set;
          for (const Cell cell : goals) set.insert(cell);
          return maze.with_start(start, heading).with_goals(set);
        },
        cells_of(maze.size()), rc::gen::elementOf(all_headings), cells);
  });
}

}  // namespace labmouse::test
