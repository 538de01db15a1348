// A race in seconds as a table, as JSON and as CSV. docs/seconds.md describes all three.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "labmouse/lab/races/drive_race.hpp"

namespace labmouse {

/// How the rules score, in a line: "the fastest run, gate to gate, of at most 5 in 600 s".
std::string formula_of(const DriveRules& rules);

/// The leaderboard for a terminal, with notes below.
std::string table_of(const DriveRace& race, bool colours);

/// The group of a race's JSON that holds the world of seconds.
nlohmann::ordered_json group_json(const DriveRace& race);

/// The race as one JSON object; `skipped` are the files that were no mazes.
std::string json_of(const DriveRace& race, const std::vector<SkippedFile>& skipped);

/// One line a contest, with a header.
std::string csv_of(const DriveRace& race);

}  // namespace labmouse
