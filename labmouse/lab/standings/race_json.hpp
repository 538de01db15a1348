// A race as a JSON value, to which other reports add what is theirs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "labmouse/lab/races/mms_race.hpp"
#include "labmouse/lab/races/tournament.hpp"

namespace labmouse {

/// What docs/races.md lists; `skipped` are the files that were no mazes. A race of programs for mms becomes a group.
nlohmann::ordered_json race_json(const Race& race, const std::vector<SkippedFile>& skipped,
                                 const MmsRace* mms = nullptr);

/// The text of a JSON file. Names come from the file system and may be no UTF-8: what is none is replaced.
std::string text_of(const nlohmann::ordered_json& json);

}  // namespace labmouse
