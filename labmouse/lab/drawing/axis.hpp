// An axis of a plot: from values to pixels, with ticks at round numbers.
#pragma once

#include <string>
#include <vector>

namespace labmouse::drawing {

class Axis {
 public:
  struct Tick {
    double at = 0.0;  ///< pixel
    std::string label;
  };

  /// Puts `low` at the pixel `begin` and `high`, which is larger, at `end`; has about `most_ticks` ticks at most, at
  /// least `least_step` (in values) apart.
  Axis(double low, double high, int begin, int end, int most_ticks, double least_step = 0.0);
  /// An axis of names, each in the middle of an equal part of the axis; name i has the value i.
  Axis(const std::vector<std::string>& names, int begin, int end);

  double place(double value) const { return begin_ + (value - low_) / (high_ - low_) * (end_ - begin_); }
  const std::vector<Tick>& ticks() const { return ticks_; }

 private:
  double low_, high_;
  int begin_, end_;
  std::vector<Tick> ticks_;
};

}  // namespace labmouse::drawing
