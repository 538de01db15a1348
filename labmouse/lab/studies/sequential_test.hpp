// Decides after each pair of contests whether one mouse is better than another: a sequential test.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "labmouse/lab/numbers/interval.hpp"
#include "labmouse/lab/numbers/wealth_process.hpp"

namespace labmouse {

/// How a difference is tested. `bets`: by WealthProcess, which keeps both error rates whatever the distribution.
/// `gsprt`: the generalised sequential probability ratio test that chess engines are tested with, between the means 0
/// and `better_by`; it takes the differences as normal, and its error rates are approximate.
enum class SequentialMethod : std::uint8_t { bets, gsprt };

inline constexpr double least_better_by = 0.0001, most_better_by = 0.5;

struct SequentialOrder {
  double better_by = 0.02;  ///< the smallest difference that matters, above 0 and at most `most_better_by`
  double alpha = 0.05;      ///< at most this is the probability of `better` or `worse` if there is no difference
  double beta = 0.05;       ///< and of `no_difference` if the difference is `better_by` or more, either way
  SequentialMethod method = SequentialMethod::bets;
};

enum class SequentialVerdict : std::uint8_t { undecided, better, worse, no_difference };
std::string_view name_of(SequentialVerdict verdict);

class SequentialTest {
 public:
  explicit SequentialTest(const SequentialOrder& order);

  /// Adds a difference of two shares of the best possible score, from -1 to 1; above 0 is better. Ignored once there is
  /// a verdict.
  void add(double difference);

  /// `undecided` until a difference decides; then it stays.
  SequentialVerdict verdict() const { return verdict_; }
  std::span<const double> differences() const { return differences_; }
  double mean() const;  ///< 0 without differences
  /// Contains the mean with a probability of at least 1 - alpha, at any time and with either method.
  Interval interval() const { return confidence_sequence(differences_, order_.alpha); }

 private:
  SequentialVerdict by_bets();
  SequentialVerdict by_ratio() const;

  SequentialOrder order_;
  std::vector<double> differences_;
  double sum_ = 0.0, squares_ = 0.0;
  WealthProcess above_zero_, below_zero_;     ///< that the mean is above 0, and that it is below
  WealthProcess below_better_, above_worse_;  ///< that it is below better_by, and above -better_by
  SequentialVerdict verdict_ = SequentialVerdict::undecided;
};

}  // namespace labmouse
