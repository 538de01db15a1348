// Any bytes as a file of failure rates: there is one or an error, and what is one makes odds that are shares.
#include "labmouse/lab/failure_rates/failure_file.hpp"
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

LABMOUSE_FUZZER(failure_rates) {
  const FoundRates read = read_rates({reinterpret_cast<const char*>(bytes), size}, "fuzzed.json");
  require(read.file.has_value() == read.error.empty());
  if (!read.file) return 0;
  const FailureRates failure_rates = rates_of(*read.file);
  require(!failure_rates.paces.empty());
  for (const RatesAtPace& pace : failure_rates.paces) {
    require(!pace.variations.empty());
    for (const RatesAtVariation& noise : pace.variations)
      for (const FailureRatesByBrightness& by_brightness : noise.by_brightness) {
        require(are_shares(by_brightness.put));
        for (const auto& levels : by_brightness.manoeuvres)
          for (const ManoeuvreRates& failure : levels)
            require(failure.crash >= 0.0 && failure.crash <= 1.0 && are_shares(failure.after));
        for (const auto& levels : by_brightness.readings)
          for (const ReadingRates& failure : levels) require(are_shares(failure));
      }
  }
  return 0;
}

}  // namespace labmouse::fuzz
