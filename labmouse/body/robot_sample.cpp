#include "labmouse/body/robot_sample.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "labmouse/chance/rng.hpp"
#include "labmouse/functions/exponential.hpp"
#include "labmouse/functions/normal.hpp"
#include "labmouse/functions/whole.hpp"

namespace labmouse {
namespace {

/// A factor by its logarithm, limited to a tenth and to ten times the nominal value.
double factor_of(double logarithm) {
  constexpr double most = 2.302585092994046;
  return exp_of(std::clamp(logarithm, -most, most));
}

/// Random numbers from a generator of their own, seeded by a name.
class Draws {
 public:
  Draws(std::uint64_t seed, std::string_view name) : rng_(seed_for(seed, name)) {}
  double next() { return NormalNumber::of(rng_.bits()); }
  double factor(double deviation) { return factor_of(deviation * next()); }
  double unit() { return rng_.unit(); }

 private:
  Rng rng_;
};

}  // namespace

RobotSample::RobotSample(const Hardware& hardware, const NoiseLevel& level, Size size, std::uint64_t seed)
    : level_(level), size_(size) {
  const Noise& noise = hardware.noise;
  double fourth_powers = 0.0;
  int drawn = 0;
  // A factor of one of the mouse's own numbers.
  const auto own = [&](Draws& draws, NoiseGroup group, double deviation) {
    const double off = level.variation * level.of(group) * draws.next();
    fourth_powers += square(square(off));
    ++drawn;
    return factor_of(off * deviation);
  };
  Draws motors(seed, "motors"), tyres(seed, "tyres"), encoders(seed, "encoders"), gyros(seed, "gyro"),
      beams(seed, "infrared");
  for (double& factor : motor) factor = own(motors, NoiseGroup::motors, noise.motor_gain);
  stiffness = own(tyres, NoiseGroup::tyres, noise.stiffness);
  grip = own(tyres, NoiseGroup::tyres, noise.grip);
  // The variation of the scales of encoders is known from logs, and not scaled.
  for (double& factor : encoder) factor = encoders.factor(level.of(NoiseGroup::encoders) * noise.encoder_scale);
  for (double& turns : ripple) turns = encoders.unit();
  gyro = own(gyros, NoiseGroup::gyro, noise.gyro_scale);
  severity_ = std::sqrt(std::sqrt(fourth_powers / drawn));
  double squares = 0.0;
  for (double& factor : infrared) {
    const double off = level.variation * level.of(NoiseGroup::infrared) * noise.infrared_gain * beams.next();
    squares += square(off);
    factor = factor_of(off);
  }
  infrared_deviation_ = std::sqrt(squares / beam_count);

  const auto area = static_cast<std::size_t>(size.area());
  Draws walls(seed, "reflectance"), floor(seed, "floor");
  reflectances_.resize(4 * area);
  for (float& share : reflectances_)
    share = static_cast<float>(walls.factor(level.of(NoiseGroup::infrared) * noise.reflectance));
  if (noise.floor_steps <= 0.0) return;
  floor_steps_.resize(2 * area);
  for (FloorStep& step : floor_steps_) {
    const bool stands = floor.unit() < noise.floor_steps;
    const double turn = floor.next(), shift = floor.next();
    if (stands)
      step = {level.of(NoiseGroup::floor) * noise.floor_turn * turn,
              level.of(NoiseGroup::floor) * noise.floor_shift * shift};
  }
}

double RobotSample::reflectance(Cell cell, Heading side) const {
  return reflectances_[static_cast<std::size_t>(4 * size_.index(cell) + static_cast<int>(side))];
}

FloorStep RobotSample::floor_step(Wall boundary) const {
  if (floor_steps_.empty() || !size_.contains(boundary.cell)) return {};
  return floor_steps_[static_cast<std::size_t>(2 * size_.index(boundary.cell) +
                                               (boundary.side == Heading::east ? 1 : 0))];
}

}  // namespace labmouse
