// The results of a race, read for a report: their JSON, and the names and seeds that locate the records.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/races/world_entry.hpp"
#include "labmouse/maze/formats/format.hpp"

namespace labmouse {

/// A mouse of the race: the names of its mazes, with the seeds of its contests there (none in a deterministic world).
struct ReportMouse {
  std::string name;
  std::map<std::string, std::set<std::uint64_t>> seeds;
};

/// A maze of the race, as the results describe it.
struct ReportMaze {
  std::string name;
  Size size;
  std::optional<int> optimum;
};

/// One world of a race.
struct ReportWorld {
  const WorldEntry* entry = nullptr;
  std::vector<ReportMouse> mice;  ///< best first
  std::vector<ReportMaze> mazes;
};

/// The results of a race with one or more worlds.
struct ReportResults {
  std::string json;  ///< the JSON as read, in one line
  std::vector<ReportWorld> worlds;
};

/// Results, or what is wrong with the text: exactly one of the two is there.
struct ReadResultsResult {
  std::optional<ReportResults> results;
  std::optional<Problem> problem;
};

/// Reads the JSON of a race. For another kind of file the problem names that kind, if it is known.
ReadResultsResult read_report_results(std::string_view text);

}  // namespace labmouse
