#include "labmouse/lab/numbers/wealth_process.hpp"

#include <algorithm>
#include <numeric>

namespace labmouse {
namespace {

/// Whether it is refuted that the mean of the differences times `sign` is at most `bar`. The higher the bar, the less
/// so.
bool refuted(std::span<const double> differences, double sign, double bar, double needed) {
  WealthProcess process(bar);
  for (const double difference : differences) process.add(sign * difference);
  return process.wealth() >= needed;
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

WealthProcess::WealthProcess(double bar) : bar_(bar) { wealths_.fill(1.0 / stakes); }

void WealthProcess::add(double difference) {
  // More evidence than this is of no use, and would overflow.
  constexpr double most = 1e200;
  // The largest possible stake loses all where the difference is -1.
  double stake = 1.0 / (1.0 + bar_);
  for (double& wealth : wealths_) {
    stake /= 2.0;
    wealth = std::min(most, wealth * (1.0 + stake * (difference - bar_)));
  }
}

double WealthProcess::wealth() const { return std::accumulate(wealths_.begin(), wealths_.end(), 0.0); }

Interval confidence_sequence(std::span<const double> differences, double error) {
  const double needed = 2.0 / error;
  return {highest_refuted(differences, 1.0, needed), -highest_refuted(differences, -1.0, needed)};
}

}  // namespace labmouse
