// What the parts of a motor's equation make of the place that a mouse comes to, each on its own.
//
// T v' = K (u - u0 sign(v)) - v, integrated twice, is linear in 1/T, K/T and K u0/T, without a derivative of anything
// that was measured (integrated-form identification, as in Garnier and Wang, "Identification of continuous-time models
// from sampled data", 2008). It is summed up as a body does, tick by tick.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "labmouse/lab/logs/log_motion.hpp"
#include "labmouse/lab/numbers/least_squares.hpp"

namespace labmouse {

/// What a log has of an axis, by ticks.
struct AxisLog {
  std::span<const double> place;  ///< mm or rad
  std::span<const double> rate;   ///< its change: mm/s or rad/s
  std::span<const double> duty;   ///< of this axis, from each tick on
  std::span<const double> other;  ///< of the other axis: unequal motors mix them
  std::span<const double> taken;  ///< what takes of the duty, but for a factor; empty without
  double factor = 0.0;            ///< as it is known
  std::size_t filtered = 1;       ///< ticks, 1 to 40, in whose mean is no more what swings about the place
};

/// The unknowns of the sum: K/T, the same for the other axis, K u0/T, what takes more of the duty than is known, 1/T
/// (as the share of the way to a steady rate that is made in a tick, by its length);
/// and those of models of the next order, K/T times the lag, and drag by the square of the rate.
enum MotorUnknown : std::size_t { by_duty, by_other, by_friction, by_taken, by_rate, by_lag, by_drag };
inline constexpr std::size_t motor_unknowns = 7;
using CurveRow = std::array<double, motor_unknowns>;

/// Squares of rates, and how many there are.
struct RateSquares {
  double sum = 0.0;
  std::size_t count = 0;
};

/// Stretches of at least 80 ticks in which it moves one way faster than that, cut into pieces of at most 300.
std::vector<TickSpan> one_way_stretches(const AxisLog& log, double slow);

/// The curves of such a stretch, and where the mouse came to, all in means over `filtered` ticks and without what a
/// place and a rate to begin with explain.
class StretchCurves {
 public:
  StretchCurves(const AxisLog& log, const TickSpan& stretch);

  void add_to(LeastSquares& problem) const;
  /// What an answer leaves of the rate, in the mean of some ticks.
  RateSquares left_by(std::span<const double> answer) const;

 private:
  std::size_t filtered_;
  std::vector<CurveRow> rows_;
  std::vector<double> places_;
};

/// What a place has beside a smooth motion, as such a rate: the rms of the middle one of many short pieces, so that
/// those in which a duty jumps do not count; 0 without a piece.
double noise_of(const AxisLog& log, std::span<const TickSpan> stretches);

}  // namespace labmouse
