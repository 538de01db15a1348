// Races as JSON and CSV. docs/reference/results.md lists all fields.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/text_sink.hpp"

namespace labmouse {

/// The races of one command, in a group each. `skipped` are the files that were no mazes. The text is passed to `sink`
/// in parts: for a million contests it would take more memory than the contests themselves.
void write_json(std::span<const Race> races, const std::vector<SkippedFile>& skipped, const TextSink& sink);

/// The same as one text, or as JSON: for a few contests.
std::string json_of(std::span<const Race> races, const std::vector<SkippedFile>& skipped);
std::string json_of(const Race& race, const std::vector<SkippedFile>& skipped);
Json race_json(std::span<const Race> races, const std::vector<SkippedFile>& skipped);

/// Where the best possible score of a maze is in the JSON of a race: `key`, and `unit` to multiply it by.
Json bound_place_json(const World& world);

/// The text of a JSON file. Names come from the file system; bytes that are not UTF-8 are replaced.
std::string text_of(const Json& json);

/// One line a contest, with a header.
void write_csv(const Race& race, const TextSink& sink);
std::string csv_of(const Race& race);

}  // namespace labmouse
