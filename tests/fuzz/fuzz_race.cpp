// Any bytes as the JSON of a race, for the readers that take it. A report has results or a problem, and those that it
// keeps are read as the same again; an earlier race has finite scores.
#include <cmath>

#include "labmouse/lab/reports/report_results.hpp"
#include "labmouse/lab/standings/baseline.hpp"
#include "tests/fuzz/check_reader.hpp"

namespace {

using labmouse::fuzz::require;

void check_report(std::string_view text) {
  const labmouse::ReadResultsResult read = labmouse::read_report_results(text);
  require(read.results.has_value() != read.problem.has_value());
  if (!read.results) return;
  const labmouse::ReadResultsResult again = labmouse::read_report_results(read.results->json);
  require(again.results && again.results->json == read.results->json);
  require(again.results->steps.mice.size() == read.results->steps.mice.size());
}

void check_baseline(std::string_view text) {
  const auto baseline = labmouse::read_baseline(text, {});
  if (!baseline) return;
  for (const auto& [mouse, mazes] : baseline->mice)
    for (const auto& [maze, scores] : mazes)
      for (const double score : scores) require(std::isfinite(score));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  check_report(text);
  check_baseline(text);
  return 0;
}
