// Changes to a contest maze that keep its rules.
#pragma once

#include "labmouse/chance/rng.hpp"
#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// Whether the rules still hold without the wall: it is no wall of the goal room or the start, and both of its posts
/// keep another one.
bool may_open_in_contest(const MazeDraft& draft, Wall wall);

/// Moves pieces of wall until the shortest way to the goal has at least `cells` cells, or a fixed number of trials is
/// over. The maze keeps the contest rules, the number of its loops, and all cells reachable.
void lengthen_way(MazeDraft& draft, Rng& rng, int cells);

}  // namespace labmouse
