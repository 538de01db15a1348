// The figures of the world of mms.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "labmouse/lab/races/race.hpp"

namespace labmouse {

struct MmsFigures : Figures {
  std::string outcome;
  std::string end;
  bool finished = false;
  JsonText score;
  std::optional<double> best_run;  ///< effective distance + turns; nothing while unfinished
  std::optional<double> run_ratio;
  JsonText statistics;  ///< an object of all values of `getStat`
  double total = 0.0;   ///< effective distance + turns of all that was done
  std::int64_t lines = 0;
  std::int64_t invalid_lines = 0;
  JsonText log;     ///< a list of the first lines
  JsonText errors;  ///< a list of the last lines
  double simulated_seconds = 0.0;
  ByClock seconds;       ///< of real time
  double visited = 0.0;  ///< as a share of the reachable cells
};

}  // namespace labmouse
