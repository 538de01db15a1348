// Logs of a mouse: CSV, read strictly.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "labmouse/lab/logs/log_columns.hpp"
#include "labmouse/maze/formats/read_result.hpp"

namespace labmouse {

/// A log has at most so long a time, and so long a gap, in ms.
inline constexpr double most_log_time = 600'000.0, most_log_gap = 50.0;

/// The rows of a log, by roles, in the units of these; empty fields are NaN.
struct Log {
  std::vector<double> times;  ///< ms since its first row, growing
  std::array<std::vector<double>, log_roles> values;

  bool has(LogRole role) const { return !values[static_cast<std::size_t>(role)].empty(); }
  std::span<const double> of(LogRole role) const { return values[static_cast<std::size_t>(role)]; }
};

/// The log, or the first thing that is wrong with its text: without a problem it has two rows or more.
struct LogResult {
  Log log;
  std::vector<Problem> problems;
};

/// Reads fields between commas, semicolons, tabs or blanks, whichever the first line has, of lines that all have as
/// many. The first line may name the columns. Empty lines and those that begin with # say nothing. `-` and `nan` are as
/// good as an empty field.
LogResult read_log(std::string_view text, const LogColumns& columns);

}  // namespace labmouse
