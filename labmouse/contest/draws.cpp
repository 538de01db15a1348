#include "labmouse/contest/draws.hpp"

#include <algorithm>

namespace labmouse {
namespace {

using Limits = std::array<double, 4>;

/// How many of these limits a value is below.
std::size_t below(double value, const Limits& limits) {
  return static_cast<std::size_t>(std::count_if(limits.begin(), limits.end(), [&](double one) { return value < one; }));
}

Draws after(Draws first, std::size_t further) { return all_draws[static_cast<std::size_t>(first) + further]; }

}  // namespace

Draws draws_of(const RobotSample& mouse) {
  const std::size_t weak = below(mouse.weaker_motor(), {0.3, 0.25, 0.2, 0.15});
  const std::size_t loose = below(mouse.grip, {0.5, 0.4, 0.3, 0.2});
  // A motor just below 0.3 finishes as few contests as tyres just below 0.4, and so on.
  if (weak > 0 && weak + 1 >= loose) return after(Draws::motor_below_30, weak - 1);
  if (loose > 0) return after(Draws::tyres_below_50, loose - 1);
  const double deviation = mouse.infrared_deviation();
  return deviation > 0.5 ? Draws::infrared_very_unequal : deviation > 0.3 ? Draws::infrared_unequal : Draws::sound;
}

}  // namespace labmouse
