// The records of a race, packed for a report.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "labmouse/lab/reports/report_results.hpp"

namespace labmouse {

/// Packed records take at most so much together, before they are compressed.
inline constexpr std::size_t most_packed_bytes = std::size_t{64} << 20U;

struct ReportRecords {
  /// The second block of a report: an object of `records` and `left_out`, how many more there were that did not fit.
  std::string json;
  /// The mazes that the records were made in, by their names.
  std::map<std::string, Maze> mazes;
  /// What was left out and why, one line each.
  std::vector<std::string> notes;
};

/// Reads the records that lie in the folder of a race, by the names that RacePaths gives: of each mouse and maze the
/// first. One that cannot be read, or that is not of this race, is left out and noted.
ReportRecords read_report_records(const ReportResults& results, const std::string& folder,
                                  std::size_t most_bytes = most_packed_bytes);

}  // namespace labmouse
