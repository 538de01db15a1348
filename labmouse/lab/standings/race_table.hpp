// A race for a terminal. docs/reference/results.md describes all of it.
#pragma once

#include <string>
#include <vector>

#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// A heading, the leaderboard, and notes below; `all` adds the columns that are rarely needed.
std::string table_of(const Race& race, bool colours, bool all = false);

/// The heading alone, in a line.
std::string heading_of(const Race& race);

/// The cells of the leaderboard, the mouse first: two rows of headings and a row a mouse.
std::vector<std::vector<std::string>> cells_of(const Race& race, bool all = false);

/// The leaderboard alone: two lines of headings and a line a mouse, with colours the best mouse in green.
std::string leaderboard_of(const Race& race, bool colours, bool all = false);

/// How much of the mazes each mouse discovered and visited while it searched, as a table in the order of the
/// leaderboard.
std::string shares_of(const Race& race);

/// For each mouse the mazes that cost it most above the bound, `count` of each.
std::string worst_of(const Race& race, int count);

}  // namespace labmouse
