// Maze generators: seeded, with the same result on every platform.
//
// depth-first, prim, kruskal, wilson and division make perfect mazes: one route between any two cells, so that width ×
// height - 1 walls are open. They differ in texture, from long winding corridors (depth-first) to many short dead ends
// (prim); wilson makes every perfect maze equally likely. `loops` then opens more walls; a larger share opens the same
// walls as a smaller one and some more.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// The parameters of a generated maze.
struct GeneratorOrder {
  Size size{16, 16};
  std::uint64_t seed = 1;
  /// Share of the remaining inner walls to open afterwards, in thousandths (0 to 1000): makes loops.
  int loops = 0;
};

/// A generator; each is defined in a file of its own.
struct Generator {
  std::string_view name;
  std::string_view summary;
  /// Why the generator cannot make such a maze.
  /// @param order any numbers.
  /// @return a line for the user, in static memory; empty if it can.
  std::string_view (*refuses)(const GeneratorOrder& order);
  /// Makes the maze, the same for the same order on every platform.
  /// @param order one that it does not refuse.
  Maze (*make)(const GeneratorOrder& order);
};

extern const Generator depth_first_generator;
extern const Generator prim_generator;
extern const Generator kruskal_generator;
extern const Generator wilson_generator;
extern const Generator division_generator;
extern const Generator empty_generator;
extern const Generator contest_generator;

/// Why the size or the share of loops is out of range, which every generator refuses.
/// @param order any numbers.
/// @return a line for the user, in static memory; empty if they are valid.
std::string_view refuses_out_of_range(const GeneratorOrder& order);

/// All generators, in the order of the list above.
std::span<const Generator* const> all_generators();
/// The generator of a name.
/// @param name exactly.
/// @return in static memory; null if there is none of that name.
const Generator* find_generator(std::string_view name);

}  // namespace labmouse
