// Whether one mouse is better than another one.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/numbers/statistics.hpp"

namespace labmouse {

/// Of fewer mazes no test says more than chance.
inline constexpr int fewest_for_verdict = 8;

enum class TestVerdict : std::uint8_t { better, worse, no_difference, too_few };

/// The p-values of several tests at once, each made larger so that the chance of any wrong finding stays 5 % (Holm
/// 1979).
std::vector<double> holm(const std::vector<double>& p);

/// Better (below 0) or worse where the corrected p-value is below 0.05 and the interval excludes 0.
TestVerdict verdict_of(const PairedDifference& found, double corrected_p);

/// "better", "worse", "no difference shown", "too few mazes".
std::string_view name_of(TestVerdict verdict);

/// Lines below verdicts: what to add where one lacks mazes, and how several are corrected. Empty where there is nothing
/// to say.
std::string verdict_notes(const std::vector<PairedDifference>& all);

}  // namespace labmouse
