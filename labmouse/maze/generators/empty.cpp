// No inner wall at all: the easiest maze, and the one with the most routes. Seed and loops change nothing.
#include "labmouse/maze/generators/generator.hpp"

namespace labmouse {
namespace {

Maze make_empty(const GeneratorOrder& order) { return Maze(MazeDraft(order.size, MazeDraft::Inside::open)); }

}  // namespace

constinit const Generator empty_generator = {
    .name = "empty",
    .summary = "no inner walls",
    .refuses = refuses_out_of_range,
    .make = make_empty,
};

}  // namespace labmouse
