// Evidence on the mean of differences that are looked at one after the other, valid at any time.
//
// Method: bets (Waudby-Smith and Ramdas 2024). Somebody begins with 1 and stakes a share of what he has on each
// difference being above `bar`. If the mean is at most `bar`, no stake gains on average, whatever came before. Then the
// probability that he ever has 1/p or more is at most p (Ville 1939), so one may look, and stop, after any difference.
// Several shares are staked side by side, each by an equal part of the first 1: none has to be chosen beforehand.
//
// Assumption: given all earlier ones, each difference has the same mean. It holds for mazes and seeds that are drawn
// independently of each other. Differences may have any distribution from -1 to 1.
#pragma once

#include <array>
#include <span>

#include "labmouse/lab/numbers/interval.hpp"

namespace labmouse {

class MeanBets {
 public:
  /// @param bar above -1, at most 1.
  explicit MeanBets(double bar);

  /// @param difference from -1 to 1.
  void add(double difference);
  /// What the bettor has: evidence that the mean is above `bar`. 1 at first.
  double capital() const;

 private:
  static constexpr int stakes = 10;

  double bar_;
  std::array<double, stakes> capitals_{};  ///< of those who stake 1/2, 1/4, 1/8 ... of the most that can be staked
};

/// The interval for the mean that contains it at all times with a probability of at least 1 - `error`: all means that
/// the bets on both sides do not refute, each at half of `error`. -1 to 1 without differences.
/// @param differences from -1 to 1, in the order in which they were found.
Interval interval_at_any_time(std::span<const double> differences, double error);

}  // namespace labmouse
