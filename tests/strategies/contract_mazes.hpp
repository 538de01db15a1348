// The mazes in which every mouse of the list of built-in mice must keep its contract.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "labmouse/grid/cell.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/slowness.hpp"

namespace labmouse::test {

struct ContractMaze {
  std::string name;
  Maze maze;
};

/// Every generator at every size that it takes, perfect and with loops, and two of the largest size. The large ones
/// take most of the time: without LABMOUSE_PROOF they come from one generator. With the sanitizers that generator alone
/// makes mazes of 16×16, and there is only one of the largest.
inline void add_generated(std::vector<ContractMaze>& mazes) {
  const auto add = [&](const Generator& generator, Size size, int loops) {
    const GeneratorOrder order{size, 7, loops};
    const bool is_chosen = &generator == &depth_first_generator;
    const int largest = thorough ? max_side : sanitized && !is_chosen ? 7 : sanitized || !is_chosen ? 16 : max_side;
    if (std::max(size.width, size.height) > largest) return;
    if (generator.refuses(order).empty())
      mazes.push_back({std::string(generator.name) + " " + std::to_string(size.width) + "x" +
                           std::to_string(size.height) + " loops " + std::to_string(loops),
                       generator.make(order)});
  };
  for (const Generator* generator : all_generators())
    for (const Size size : {Size{1, 1}, Size{1, 2}, Size{2, 1}, Size{2, 2}, Size{5, 7}, Size{16, 16}, Size{32, 32}})
      for (const int loops : {0, 150}) add(*generator, size, loops);
  mazes.push_back({"depth-first 64x64", depth_first_generator.make({{64, 64}, 7, 100})});
  add(wilson_generator, {64, 64}, 0);
}

/// Starts and goals in other places than usual.
inline void add_places(std::vector<ContractMaze>& mazes) {
  const Maze maze = prim_generator.make({{16, 16}, 3, 100});
  for (const Heading heading : all_headings) {
    mazes.push_back({"start in a corner, heading " + std::string(name_of(heading)), maze.with_start({0, 0}, heading)});
    mazes.push_back({"start elsewhere, heading " + std::string(name_of(heading)), maze.with_start({11, 4}, heading)});
  }
  mazes.push_back({"start in a goal", maze.with_start({8, 8}, Heading::west)});
  CellSet corners;
  for (const Cell corner : {Cell{15, 0}, Cell{0, 15}, Cell{15, 15}}) corners.insert(corner);
  mazes.push_back({"three goals far apart", maze.with_goals(corners)});
}

/// What only a person thinks of.
inline void add_drawn(std::vector<ContractMaze>& mazes) {
  mazes.push_back({"a goal that cannot be reached", drawn(R"(
                    o---o---o---o---o---o
                    |               |   |
                    o   o---o   o---o   o
                    |   |           |   |
                    o   o   o---o   o   o
                    |   |   | G |   |   |
                    o   o   o---o   o   o
                    |       |           |
                    o   o---o---o---o   o
                    | S |               |
                    o---o---o---o---o---o
                  )")});
  mazes.push_back({"a start without a way out", drawn(R"(
                    o---o---o
                    |     G |
                    o---o   o
                    | S |   |
                    o---o---o
                  )")});
  mazes.push_back({"a start that is a goal without a way out", drawn(R"(
                    o---o---o
                    |       |
                    o---o   o
                    | S |   |
                    o---o---o
                  )")});
  CellSet start;
  start.insert({0, 0});
  mazes.back().maze = mazes.back().maze.with_goals(start);
  mazes.push_back({"the only way begins behind", drawn(R"(
                    o---o---o---o
                    | S |       |
                    o   o   o   o
                    |       | G |
                    o---o---o---o
                  )")});
  mazes.push_back({"an island that a wall follower goes round", drawn(R"(
                    o---o---o---o---o---o
                    |                   |
                    o   o---o---o   o   o
                    |   |       |       |
                    o   o   o   o   o   o
                    |   |   | G         |
                    o   o   o---o   o   o
                    |   |       |       |
                    o   o---o   o---o   o
                    | S |               |
                    o---o---o---o---o---o
                  )")});
}

inline const std::vector<ContractMaze>& contract_mazes() {
  static const std::vector<ContractMaze> mazes = [] {
    std::vector<ContractMaze> all;
    add_generated(all);
    add_places(all);
    add_drawn(all);
    return all;
  }();
  return mazes;
}

}  // namespace labmouse::test
