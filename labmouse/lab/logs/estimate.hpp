// A number that a log says, and how sure it is.
#pragma once

#include <span>

namespace labmouse {

/// Without an error above 0 the log says nothing of it.
struct Estimate {
  double value = 0.0;
  double error = 0.0;  ///< standard error

  bool said() const { return error > 0.0; }
};

/// What counts as said: with an error of at most so much, which is not 0.
Estimate said_within(double value, double error, double most);

/// Whether a model leaves less than another one of the data that neither was fitted to, by the squares that each leaves
/// of the same two or more blocks: half of it, or a tenth less and not by chance.
bool leaves_less(std::span<const double> one, std::span<const double> other);

}  // namespace labmouse
