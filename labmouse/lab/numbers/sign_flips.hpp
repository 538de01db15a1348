// The permutation test of paired differences.
#pragma once

#include <cstdint>
#include <span>

namespace labmouse {

/// Whether two scores are equal up to rounding errors: their difference is below 1e-9.
constexpr bool is_equal(double difference) { return difference > -1e-9 && difference < 1e-9; }

/// Two-sided p-value of the sign-flip test (Fisher 1935): the share of all assignments of signs to the differences for
/// which the mean is at least as far from 0 as the observed one. With up to 12 nonzero differences all assignments are
/// tried, with more 9,999 random ones. Returns 1 where all differences are 0.
double sign_flip_test(std::span<const double> differences, std::uint64_t seed);

}  // namespace labmouse
