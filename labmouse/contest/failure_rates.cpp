#include "labmouse/contest/failure_rates.hpp"

namespace labmouse {

RatesAtVariation no_failures() {
  constexpr std::size_t surely_wall = evidence_classes - 1, surely_gap = 0;
  RatesAtVariation none;
  for (FailureRatesByBrightness& failure_rates : none.by_brightness)
    for (const Reading reading : all_readings)
      for (ReadingRates& shares : failure_rates.readings[static_cast<std::size_t>(reading)]) {
        shares[is_of_wall(reading) ? surely_wall : surely_gap] = 1.0;
      }
  return none;
}

}  // namespace labmouse
