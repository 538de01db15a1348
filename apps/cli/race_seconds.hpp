// labmouse race in the world of seconds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contests.hpp"

namespace labmouse::cli {

struct SecondsRace {
  std::vector<std::string> mice;
  Contests contests;
  std::string robot = "classic", rules = "all-japan";
  std::string format, out;
  bool overwrite = false;
  std::optional<double> fail_above;  ///< seconds
};

/// Holds the race, prints it and saves what was asked for; returns the exit code.
int race_in_seconds(const SecondsRace& options);

}  // namespace labmouse::cli
