#include "labmouse/lab/studies/sequential_test.hpp"

#include <cmath>

#include "labmouse/functions/exponential.hpp"

namespace labmouse {

std::string_view name_of(SequentialVerdict verdict) {
  switch (verdict) {
    case SequentialVerdict::undecided:
      return "undecided";
    case SequentialVerdict::better:
      return "better";
    case SequentialVerdict::worse:
      return "worse";
    case SequentialVerdict::no_difference:
      break;
  }
  return "no difference";
}

// That the mean is below a bar is tested by the negated differences.
SequentialTest::SequentialTest(const SequentialOrder& order)
    : order_(order),
      above_zero_(0.0),
      below_zero_(0.0),
      below_better_(-order.better_by),
      above_worse_(-order.better_by) {}

void SequentialTest::add(double difference) {
  if (verdict_ != SequentialVerdict::undecided) return;
  differences_.push_back(difference);
  sum_ += difference;
  squares_ += difference * difference;
  above_zero_.add(difference);
  below_zero_.add(-difference);
  below_better_.add(-difference);
  above_worse_.add(difference);
  verdict_ = order_.method == SequentialMethod::bets ? by_bets() : by_ratio();
}

double SequentialTest::mean() const {
  return differences_.empty() ? 0.0 : sum_ / static_cast<double>(differences_.size());
}

SequentialVerdict SequentialTest::by_bets() {
  // Without a difference two verdicts are wrong. A difference can be overlooked in one way only: a mean is not both
  // better_by and -better_by.
  if (above_zero_.wealth() >= 2.0 / order_.alpha) return SequentialVerdict::better;
  if (below_zero_.wealth() >= 2.0 / order_.alpha) return SequentialVerdict::worse;
  const bool none = below_better_.wealth() >= 1.0 / order_.beta && above_worse_.wealth() >= 1.0 / order_.beta;
  return none ? SequentialVerdict::no_difference : SequentialVerdict::undecided;
}

SequentialVerdict SequentialTest::by_ratio() const {
  // Equal scores in all mazes so far do not mean that there is no variance: one difference of 1 and one of -1 are
  // added.
  const auto count = static_cast<double>(differences_.size());
  const double variance = (squares_ + 2.0 - sum_ * sum_ / (count + 2.0)) / (count + 1.0);
  const auto ratio = [&](double sign) {
    return order_.better_by * (sign * sum_ - count * order_.better_by / 2.0) / variance;
  };
  const double found = log_of((1.0 - order_.beta) / (order_.alpha / 2.0));
  const double none = log_of(order_.beta / (1.0 - order_.alpha / 2.0));
  if (ratio(1.0) >= found) return SequentialVerdict::better;
  if (ratio(-1.0) >= found) return SequentialVerdict::worse;
  return ratio(1.0) <= none && ratio(-1.0) <= none ? SequentialVerdict::no_difference : SequentialVerdict::undecided;
}

}  // namespace labmouse
