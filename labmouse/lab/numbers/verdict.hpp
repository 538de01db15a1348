// Whether one mouse is better than another one.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/numbers/statistics.hpp"

namespace labmouse {

/// Fewest mazes for a verdict; with fewer it is TestVerdict::too_few.
inline constexpr int fewest_for_verdict = 8;

enum class TestVerdict : std::uint8_t { better, worse, no_difference, too_few };

/// P-values corrected for several tests (Holm 1979), in the order given: at level 0.05, the family-wise error rate is 5
/// %.
std::vector<double> holm(const std::vector<double>& p);

/// Better (differences below 0) or worse if the corrected p-value is below 0.05 and the interval excludes 0.
TestVerdict verdict_of(const PairedDifference& found, double corrected_p);

/// "better", "worse", "no difference shown", "too few mazes".
std::string_view name_of(TestVerdict verdict);

/// Notes to print below verdicts: how many mazes are missing, and for how many comparisons the p-values are corrected.
/// May be empty.
std::string verdict_notes(const std::vector<PairedDifference>& all);

}  // namespace labmouse
