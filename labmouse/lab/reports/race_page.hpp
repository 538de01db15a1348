// A race that was just run as one page for a browser.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// The page with the race and its replays; the page alone where the race has no contests.
/// @param records of its contests; empty ones are left out.
/// @param page must pass wrong_page().
std::string race_page(const Race& race, const std::vector<std::string>& records, std::string_view page);

}  // namespace labmouse
