// Evidence on the mean of differences that is valid at any time: a test by betting.
//
// Method: a wealth process (Waudby-Smith and Ramdas 2024). It begins with 1, and a share of it is staked on each
// difference being above `bar`. No stake can lose more than all, so the wealth is never negative. If the mean of every
// difference, given the earlier ones, is at most `bar`, the wealth is a supermartingale, and the probability that it
// ever reaches 1/p is at most p (Ville 1939). So one may look after each difference, and stop at any time. The wealth
// is the mean of several such processes with fixed stakes, so none has to be chosen for the differences at hand.
//
// Assumption: given all earlier ones, each difference has the same mean. It holds for mazes and seeds that are drawn
// independently of each other. Differences may have any distribution from -1 to 1.
#pragma once

#include <array>
#include <span>

#include "labmouse/lab/numbers/interval.hpp"

namespace labmouse {

class WealthProcess {
 public:
  /// @param bar above -1, at most 1.
  explicit WealthProcess(double bar);

  /// @param difference from -1 to 1.
  void add(double difference);
  /// Evidence that the mean is above `bar`: an e-value, 1 at first.
  double wealth() const;

 private:
  static constexpr int stakes = 10;

  double bar_;
  std::array<double, stakes> wealths_{};  ///< with stakes of 1/2, 1/4, 1/8 ... of the largest possible one
};

/// The interval of a confidence sequence: it contains the mean at all times with a probability of at least 1 - `error`.
/// It has all means that neither side refutes, each at half of `error`. -1 to 1 without differences.
/// @param differences from -1 to 1, in the order in which they were found.
Interval confidence_sequence(std::span<const double> differences, double error);

}  // namespace labmouse
