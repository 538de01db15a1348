#include <algorithm>
#include <numeric>

#include "labmouse/lab/hazards/hazard_file.hpp"

namespace labmouse {
namespace {

/// What was counted of more than what is asked for counts like so many.
constexpr double as_many = 20.0;

/// A share by a count, and by what it is where more was counted.
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

ManoeuvreHazard hazard_by(const ManoeuvreCount& count, const ManoeuvreHazard& elsewhere) {
  return {share_by(count.crashes, count.times, elsewhere.crash), share_by(count.slid, count.crashes, elsewhere.slid),
          shares_by(count.after, elsewhere.after)};
}

/// A mouse of which nothing was counted stays as far astray as it is.
ManoeuvreHazard nothing_counted(std::size_t level) {
  ManoeuvreHazard hazard;
  hazard.after = {};
  hazard.after[level] = 1.0;
  return hazard;
}

/// Counts of one noise, and those of all noises at its pace: a mouse that is as weak under another noise fails alike.
HazardsAtNoise odds_of(const HazardTally& tally, const HazardTally& any_noise) {
  if (tally.noise == 0.0) return no_hazards();
  const HazardCounts all = tally.all();
  HazardsAtNoise odds = no_hazards();
  odds.noise = tally.noise;
  for (std::size_t luck = 0; luck < luck_classes; ++luck) {
    const HazardCounts &counts = tally.by_luck[luck], &alike = any_noise.by_luck[luck];
    HazardsByLuck& by_luck = odds.by_luck[luck];
    by_luck.put = shares_by(counts.put, shares_by(alike.put, shares_by(all.put, by_luck.put)));
    for (std::size_t level = 0; level < astray_levels; ++level) {
      const ManoeuvreHazard usual = hazard_by(all.at(level), nothing_counted(level));
      for (std::size_t i = 0; i < all_manoeuvres.size(); ++i)
        by_luck.manoeuvres[i][level] =
            hazard_by(counts.manoeuvres[i][level],
                      hazard_by(alike.manoeuvres[i][level], hazard_by(all.manoeuvres[i][level], usual)));
      for (std::size_t i = 0; i < all_readings.size(); ++i) {
        ReadingHazard& reading = by_luck.readings[i][level];
        reading = shares_by(
            counts.readings[i][level].by_evidence,
            shares_by(alike.readings[i][level].by_evidence, shares_by(all.readings[i][level].by_evidence, reading)));
      }
    }
  }
  return odds;
}

}  // namespace

Hazards hazards_of(const HazardFile& file) {
  Hazards hazards;
  hazards.spread = file.spread;
  const auto at_pace = [&](double pace) {
    HazardTally sum;
    for (const HazardTally& tally : file.tallies)
      if (tally.pace == pace) sum += tally;
    return sum;
  };
  HazardTally any_noise;
  for (const HazardTally& tally : file.tallies) {
    if (hazards.paces.empty() || hazards.paces.back().pace != tally.pace) {
      hazards.paces.push_back({tally.pace, {}});
      any_noise = at_pace(tally.pace);
      if (tally.noise > 0.0) hazards.paces.back().noises.push_back(no_hazards());
    }
    hazards.paces.back().noises.push_back(odds_of(tally, any_noise));
  }
  return hazards;
}

}  // namespace labmouse
