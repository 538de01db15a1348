#include "labmouse/lab/numbers/mean_bets.hpp"

#include <algorithm>
#include <numeric>

namespace labmouse {
namespace {

/// Whether bets refute that the mean of the differences times `sign` is at most `bar`. The higher the bar, the less so.
bool refuted(std::span<const double> differences, double sign, double bar, double needed) {
  MeanBets bets(bar);
  for (const double difference : differences) bets.add(sign * difference);
  return bets.capital() >= needed;
}

/// The highest bar that is refuted; -1 if none is.
double highest_refuted(std::span<const double> differences, double sign, double needed) {
  constexpr int halvings = 30;
  double low = -1.0, high = 1.0;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2.0;
    (refuted(differences, sign, middle, needed) ? low : high) = middle;
  }
  return low;
}

}  // namespace

MeanBets::MeanBets(double bar) : bar_(bar) { capitals_.fill(1.0 / stakes); }

void MeanBets::add(double difference) {
  // More evidence than this is of no use, and would overflow.
  constexpr double most = 1e200;
  // The most that can be staked is lost where the difference is -1.
  double stake = 1.0 / (1.0 + bar_);
  for (double& capital : capitals_) {
    stake /= 2.0;
    capital = std::min(most, capital * (1.0 + stake * (difference - bar_)));
  }
}

double MeanBets::capital() const { return std::accumulate(capitals_.begin(), capitals_.end(), 0.0); }

Interval interval_at_any_time(std::span<const double> differences, double error) {
  const double needed = 2.0 / error;
  return {highest_refuted(differences, 1.0, needed), -highest_refuted(differences, -1.0, needed)};
}

}  // namespace labmouse
