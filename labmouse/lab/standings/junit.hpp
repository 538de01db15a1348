// The results of races as JUnit XML, which the build servers of courses read.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// A test suite for each mouse in each world, with a test for each contest, which fails if the contest was not
/// finished. A contest that was not judged is a skipped test.
/// @param limit If there is one, a last test fails if the mean over all contests, in the unit of the world and with
/// failed contests at the limit, is above it.
std::string junit_of(std::span<const Race> races, std::optional<double> limit);

}  // namespace labmouse
