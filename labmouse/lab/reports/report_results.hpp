// The results of a race as a report takes them: as they are, and what has to be known of them to find their records.
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

/// A mouse of the race: the mazes that it ran in by their names, each with the seeds of its contests (none in a world
/// without dice).
struct ReportMouse {
  std::string name;
  std::map<std::string, std::set<std::uint64_t>> seeds;
};

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

struct ReportResults {
  std::string json;  ///< as it is, in one line
  std::vector<ReportWorld> worlds;
};

/// Results, or what is wrong with the text: exactly one of the two is there.
struct ReadResultsResult {
  std::optional<ReportResults> results;
  std::optional<Problem> problem;
};

/// Reads the JSON of a race. Of what is something else it says what it is, where that can be seen.
ReadResultsResult read_report_results(std::string_view text);

}  // namespace labmouse
