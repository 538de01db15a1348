// How much less a long test should do.
#pragma once

#include <algorithm>
#include <cstdlib>

namespace labmouse::test {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
inline constexpr bool sanitized = __has_feature(address_sanitizer);
#else
inline constexpr bool sanitized = false;
#endif

/// Whether a long test runs all of its cases: `make proof` sets LABMOUSE_PROOF. Never under the sanitizers, where a
/// case takes ten times as long.
inline const bool thorough = !sanitized && std::getenv("LABMOUSE_PROOF") != nullptr;

/// Whether the sanitizers are in it and it is not `make proof` that runs it.
inline const bool briefly_sanitized = sanitized && std::getenv("LABMOUSE_PROOF") == nullptr;

/// Where a test is not thorough, it runs one case of this many.
inline const int slowness = sanitized ? 60 : thorough ? 1 : 12;

/// How many of so many cases a long test runs: at least one.
inline int some_of(int cases) { return std::max(1, cases / slowness); }

/// Where a test is not thorough, an eighth of its cases: for tests of which a twelfth would be too few.
template <class Count>
Count fewer(Count cases) {
  return thorough ? cases : (cases + 7) / 8;
}

/// With the sanitizers a tenth of the cases: for tests that are short enough without them.
constexpr int tenth(int cases) { return sanitized ? (cases + 9) / 10 : cases; }

}  // namespace labmouse::test

/// Leaves a test out with the sanitizers: for tests of numbers, of whose cases a tenth would tell nothing, and whose
/// code other tests run.
#define LABMOUSE_SKIP_SANITIZED() \
  if (labmouse::test::sanitized) GTEST_SKIP() << "only computes longer with the sanitizers"
