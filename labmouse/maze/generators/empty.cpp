// No inner wall at all: the easiest maze, and the one with the most routes. Seed and loops change nothing.
#include "labmouse/maze/generators/generator.hpp"

namespace labmouse {
namespace {

Maze make(const GeneratorOrder& order) { return Maze(MazeDraft(order.size, MazeDraft::Inside::open)); }

}  // namespace

constinit const Generator empty_generator = {
    .name = "empty", .summary = "no inner walls", .refuses = refuses_out_of_range, .make = make};

}  // namespace labmouse
