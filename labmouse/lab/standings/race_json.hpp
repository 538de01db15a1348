// Races as JSON and CSV. docs/reference/results.md lists all fields.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/text_sink.hpp"

namespace labmouse {

/// The races of one command, in a group each. `skipped` are the files that were no mazes. The text is handed over part
/// by part, because that of a million contests is longer than all that is known of them.
void write_json(std::span<const Race> races, const std::vector<SkippedFile>& skipped, const TextSink& sink);

/// The same as one text, or as JSON: for a few contests.
std::string json_of(std::span<const Race> races, const std::vector<SkippedFile>& skipped);
std::string json_of(const Race& race, const std::vector<SkippedFile>& skipped);
Json race_json(std::span<const Race> races, const std::vector<SkippedFile>& skipped);

/// The text of a JSON file. Names come from the file system and may be no UTF-8: what is none is replaced.
std::string text_of(const Json& json);

/// One line a contest, with a header.
void write_csv(const Race& race, const TextSink& sink);
std::string csv_of(const Race& race);

}  // namespace labmouse
