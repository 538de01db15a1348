// A race of programs written for mms as a table, as JSON and as CSV. docs/mms.md describes all three.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "labmouse/lab/races/mms_race.hpp"

namespace labmouse {

/// How mms scores, as a formula over the names of `getStat`.
inline constexpr const char* mms_formula =
    "best-run-effective-distance + best-run-turns + 0.1 * (total-effective-distance + total-turns); 2000 while "
    "unsolved";

/// The leaderboard for a terminal, with notes below.
std::string table_of(const MmsRace& race, bool colours);

/// The group of a race's JSON that holds the world of mms.
nlohmann::ordered_json group_json(const MmsRace& race);

/// One line a run, with a header.
std::string csv_of(const MmsRace& race);

/// One run for a terminal, without a drawing: the statistics, the score beside the best possible one, what was wrong
/// with its lines, how it ended, and the last lines of its standard error.
std::string report_of(const std::string& mouse, const NamedMaze& maze, const MmsRun& run);

}  // namespace labmouse
