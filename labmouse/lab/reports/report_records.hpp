// The records of a race, packed for a report.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "labmouse/lab/reports/report_results.hpp"

namespace labmouse {

/// Limit of the size of all packed records together, in bytes before compression.
inline constexpr std::size_t most_packed_bytes = std::size_t{64} << 20U;

/// The packed records of a race and their mazes.
struct ReportRecords {
  /// The second block of a report: an object of `records` and `left_out`, the number of records that did not fit.
  std::string json;
  /// The mazes of the records, by their names.
  std::map<std::string, Maze> mazes;
  /// What was left out and why, one line each.
  std::vector<std::string> notes;
};

/// Reads the record of the first contest of each mouse and maze from the folder of a race (RacePaths gives the file
/// names). Records that cannot be read, or are of another race, are left out and noted.
ReportRecords read_report_records(const ReportResults& results, const std::string& folder,
                                  std::size_t most_bytes = most_packed_bytes);

/// Packs the texts of records that this program has just written, all of contests in that world.
/// @param mazes all mazes of the race, by their names.
ReportRecords pack_records(const WorldEntry& world, std::span<const std::string> texts,
                           std::map<std::string, Maze> mazes, std::size_t most_bytes = most_packed_bytes);

}  // namespace labmouse
