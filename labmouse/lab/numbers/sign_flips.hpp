// The permutation test of paired differences.
#pragma once

#include <cstdint>
#include <span>

namespace labmouse {

/// Whether a difference of two scores is 0 but for rounding: closer to it than a billionth.
constexpr bool is_equal(double difference) { return difference > -1e-9 && difference < 1e-9; }

/// Two-sided p-value of the sign-flip test (Fisher 1935): the share of all ways to exchange the two scores of each pair
/// whose mean difference is at least as far from 0 as this one. All ways are tried for up to 12 differences that are
/// not 0; of more, 9,999 random ones. 1 where all differences are 0.
double sign_flip_test(std::span<const double> differences, std::uint64_t seed);

}  // namespace labmouse
