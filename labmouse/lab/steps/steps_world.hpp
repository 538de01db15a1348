// The world of the capstone project: a step turns, then moves up to three cells; a run costs its steps.
#pragma once

#include <array>
#include <memory>

#include "labmouse/contest/record.hpp"
#include "labmouse/contest/rules.hpp"
#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/records/record_parts.hpp"
#include "labmouse/lab/steps/steps_figures.hpp"

namespace labmouse {

/// What can be set of the world.
inline constexpr std::array steps_rows = {
    row<&Rules::budget>({.name = "budget",
                         .placeholder = "N",
                         .meaning = "Step limit of a contest, for both runs together",
                         .default_value = "1000",
                         .low = 1,
                         .high = longest_record})};

/// Contests under these rules. Their ContestOutput::run is set.
std::shared_ptr<const World> steps_world(const Rules& rules = {});

}  // namespace labmouse
