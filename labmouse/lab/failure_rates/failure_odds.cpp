#include <algorithm>
#include <numeric>

#include "labmouse/lab/failure_rates/failure_file.hpp"

namespace labmouse {
namespace {

/// Weight of the prior, which is the share in a wider class, as a number of counts.
constexpr double as_many = 20.0;

/// A share estimated from counts, with the share in a wider class as prior.
double share_by(std::int64_t part, std::int64_t all, double elsewhere) {
  return (static_cast<double>(part) + as_many * elsewhere) / (static_cast<double>(all) + as_many);
}

template <std::size_t Size>
std::array<double, Size> shares_by(const std::array<std::int64_t, Size>& counts,
                                   const std::array<double, Size>& elsewhere) {
  const std::int64_t all = std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
  std::array<double, Size> shares{};
  for (std::size_t i = 0; i < Size; ++i) shares[i] = share_by(counts[i], all, elsewhere[i]);
  return shares;
}

ManoeuvreRates rates_by(const ManoeuvreCount& count, const ManoeuvreRates& elsewhere) {
  return {share_by(count.crashes, count.times, elsewhere.crash), share_by(count.slid, count.crashes, elsewhere.slid),
          shares_by(count.after, elsewhere.after)};
}

/// Rates if nothing was counted: no crash, and the level of localization error does not change.
ManoeuvreRates nothing_counted(std::size_t level) {
  ManoeuvreRates failure;
  failure.after = {};
  failure.after[level] = 1.0;
  return failure;
}

/// Rates for one variation. `any` has the counts of all variations at the same pace: walls that look alike are read
/// alike under all of them.
RatesAtVariation odds_of(const FailureTally& tally, const FailureTally& any) {
  if (tally.variation == 0.0) return no_failures();
  const FailureCounts all = tally.all();
  RatesAtVariation odds = no_failures();
  odds.variation = tally.variation;
  for (std::size_t bright = 0; bright < brightness_classes; ++bright) {
    const FailureCounts &counts = tally.by_brightness[bright], &alike = any.by_brightness[bright];
    FailureRatesByBrightness& rates = odds.by_brightness[bright];
    rates.put = shares_by(counts.put, shares_by(alike.put, shares_by(all.put, rates.put)));
    for (std::size_t level = 0; level < position_error_levels; ++level) {
      const ManoeuvreRates usual = rates_by(all.at(level), nothing_counted(level));
      for (std::size_t i = 0; i < all_manoeuvres.size(); ++i)
        rates.manoeuvres[i][level] =
            rates_by(counts.manoeuvres[i][level],
                     rates_by(alike.manoeuvres[i][level], rates_by(all.manoeuvres[i][level], usual)));
      for (std::size_t i = 0; i < all_readings.size(); ++i) {
        ReadingRates& reading = rates.readings[i][level];
        reading = shares_by(
            counts.readings[i][level].by_evidence,
            shares_by(alike.readings[i][level].by_evidence, shares_by(all.readings[i][level].by_evidence, reading)));
      }
    }
  }
  return odds;
}

}  // namespace

FailureRates rates_of(const FailureFile& file) {
  FailureRates failure_rates;
  failure_rates.noise = file.noise;
  const auto at_pace = [&](double pace) {
    FailureTally sum;
    for (const FailureTally& tally : file.tallies)
      if (tally.pace == pace) sum += tally;
    return sum;
  };
  FailureTally any;
  for (const FailureTally& tally : file.tallies) {
    if (failure_rates.paces.empty() || failure_rates.paces.back().pace != tally.pace) {
      failure_rates.paces.push_back({tally.pace, {}});
      any = at_pace(tally.pace);
      if (tally.variation > 0.0) failure_rates.paces.back().variations.push_back(no_failures());
    }
    failure_rates.paces.back().variations.push_back(odds_of(tally, any));
  }
  return failure_rates;
}

}  // namespace labmouse
