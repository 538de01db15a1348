// The statistics of mms under their names.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "labmouse/external/mms/statistics.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/numbers.hpp"

namespace labmouse {

/// Effective distance + turns of the best run, which the score contains; nothing where no run finished.
inline std::optional<double> best_run(const MmsStatistics& statistics) {
  if (!statistics.finished) return std::nullopt;
  return decimal(statistics.best_run_effective_distance) + decimal(statistics.best_run_turns);
}

/// Effective distance + turns of all runs, a tenth of which is in the score.
inline double total(const MmsStatistics& statistics) {
  return decimal(statistics.total_effective_distance) + decimal(statistics.total_turns);
}

/// The number with as few decimals as needed, whole numbers without: 265.2, 12.
inline Json short_json(float value) {
  const auto whole = static_cast<std::int64_t>(value);
  if (value == static_cast<float>(whole)) return whole;
  return decimal(value);
}

inline Json statistics_json(const MmsStatistics& statistics) {
  auto json = Json::object();
  for (const MmsStatistic& statistic : mms_statistics)
    json[std::string(statistic.name)] = short_json(statistics.*statistic.value);
  return json;
}

}  // namespace labmouse
