#include "labmouse/contest/hazards.hpp"

namespace labmouse {

HazardsAtNoise no_hazards() {
  constexpr std::size_t surely_wall = evidence_classes - 1, surely_gap = 0;
  HazardsAtNoise none;
  for (HazardsByLuck& hazards : none.by_luck)
    for (const Reading reading : all_readings)
      for (ReadingHazard& shares : hazards.readings[static_cast<std::size_t>(reading)]) {
        shares[is_of_wall(reading) ? surely_wall : surely_gap] = 1.0;
      }
  return none;
}

}  // namespace labmouse
