// A race as a table, as JSON and as CSV. docs/races.md describes all three.
#pragma once

#include <string>
#include <vector>

#include "labmouse/lab/races/mms_race.hpp"
#include "labmouse/lab/standings/standings.hpp"

namespace labmouse {

/// The leaderboard for a terminal, with notes below.
std::string table_of(const Race& race, bool colours);

/// The race as one JSON object, with that of programs for mms where there is one; `skipped` are the files that were no
/// mazes.
std::string json_of(const Race& race, const std::vector<SkippedFile>& skipped, const MmsRace* mms = nullptr);

/// One line a contest, with a header.
std::string csv_of(const Race& race);

/// How much of the mazes each mouse discovered and visited while exploring, as a table in the order of the leaderboard.
std::string shares_of(const Race& race);

/// For each mouse the mazes that cost it most above the bound, `count` of each.
std::string worst_of(const Race& race, int count);

}  // namespace labmouse
