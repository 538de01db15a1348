// Any bytes as the JSON of a race, for the readers that take it. A report has results or a problem, and those that it
// keeps are read as the same again; an earlier race has finite scores.
#include <cmath>
#include <map>

#include "labmouse/lab/reports/report_results.hpp"
#include "labmouse/lab/standings/baseline.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

namespace {

void check_report(std::string_view text) {
  const ReadResultsResult read = read_report_results(text);
  require(read.results.has_value() != read.problem.has_value());
  if (!read.results) return;
  const ReadResultsResult again = read_report_results(read.results->json);
  require(again.results && again.results->json == read.results->json);
  require(again.results->worlds.size() == read.results->worlds.size());
}

void check_baseline(std::string_view text, const World& world) {
  const ReadBaselineResult read = read_baseline(text, world);
  require(read.baseline.has_value() == read.error.empty());
  if (!read.baseline) return;
  for (const auto& [mouse, mazes] : read.baseline->mice)
    for (const auto& [maze, scores] : mazes)
      require(std::isfinite(scores.sum) && std::isfinite(scores.finished_sum) && scores.finished <= scores.contests);
}

}  // namespace

LABMOUSE_FUZZER(race) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  check_report(text);
  for (const WorldEntry* entry : all_worlds()) {
    static const std::map<const WorldEntry*, std::shared_ptr<const World>> worlds = [] {
      std::map<const WorldEntry*, std::shared_ptr<const World>> made;
      for (const WorldEntry* each : all_worlds()) made[each] = each->make({}).world;
      return made;
    }();
    check_baseline(text, *worlds.at(entry));
  }
  return 0;
}

}  // namespace labmouse::fuzz
