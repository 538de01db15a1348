#include "labmouse/lab/numbers/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace labmouse {

std::vector<double> holm(const std::vector<double>& p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<double> corrected(p.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    largest = std::max(largest, std::min(1.0, p[order[i]] * static_cast<double>(p.size() - i)));
    corrected[order[i]] = largest;
  }
  return corrected;
}

TestVerdict verdict_of(const PairedDifference& found, double corrected_p) {
  constexpr double level = 0.05;
  if (found.count < fewest_for_verdict) return TestVerdict::too_few;
  if (corrected_p >= level) return TestVerdict::no_difference;
  if (found.interval.high < 0.0) return TestVerdict::better;
  return found.interval.low > 0.0 ? TestVerdict::worse : TestVerdict::no_difference;
}

std::string_view name_of(TestVerdict verdict) {
  switch (verdict) {
    case TestVerdict::better:
      return "better";
    case TestVerdict::worse:
      return "worse";
    case TestVerdict::no_difference:
      return "no difference shown";
    case TestVerdict::too_few:
      break;
  }
  return "too few mazes";
}

std::string verdict_notes(const std::vector<PairedDifference>& all) {
  int fewest = fewest_for_verdict;
  for (const PairedDifference& found : all) fewest = std::min(fewest, found.count);
  std::string notes;
  if (fewest < fewest_for_verdict)
    notes = fmt::format(
        "A verdict needs at least {} mazes that both mice have run; here are {}. Add {} or more with --mazes.\n",
        fewest_for_verdict, fewest, fewest_for_verdict - fewest);
  if (all.size() > 1)
    notes += fmt::format(
        "Verdicts are corrected for {} comparisons (Holm). Each interval holds on its own: one in twenty misses by "
        "chance.\n",
        all.size());
  return notes;
}

}  // namespace labmouse
