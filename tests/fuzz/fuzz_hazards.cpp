// Any bytes as a file of hazards: there is one or an error, and what is one makes odds that are shares.
#include "labmouse/lab/hazards/hazard_file.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

namespace {

template <class Shares>
bool are_shares(const Shares& shares) {
  double sum = 0.0;
  for (const double share : shares) {
    if (!(share >= 0.0 && share <= 1.0)) return false;
    sum += share;
  }
  return sum > 0.999 && sum < 1.001;
}

}  // namespace

LABMOUSE_FUZZER(hazards) {
  const FoundHazards read = read_hazards({reinterpret_cast<const char*>(bytes), size}, "fuzzed.json");
  require(read.file.has_value() == read.error.empty());
  if (!read.file) return 0;
  const Hazards hazards = hazards_of(*read.file);
  require(!hazards.paces.empty());
  for (const HazardsAtPace& pace : hazards.paces) {
    require(!pace.noises.empty());
    for (const HazardsAtNoise& noise : pace.noises)
      for (const HazardsByLuck& by_luck : noise.by_luck) {
        require(are_shares(by_luck.put));
        for (const auto& levels : by_luck.manoeuvres)
          for (const ManoeuvreHazard& hazard : levels)
            require(hazard.crash >= 0.0 && hazard.crash <= 1.0 && are_shares(hazard.after));
        for (const auto& levels : by_luck.readings)
          for (const ReadingHazard& hazard : levels) require(are_shares(hazard));
      }
  }
  return 0;
}

}  // namespace labmouse::fuzz
