#include "labmouse/body/specimen.hpp"

#include <algorithm>
#include <string_view>

#include "labmouse/chance/dice.hpp"
#include "labmouse/functions/exponential.hpp"
#include "labmouse/functions/normal.hpp"

namespace labmouse {
namespace {

/// Normal numbers of one name.
class Draws {
 public:
  Draws(std::uint64_t seed, std::string_view name) : dice_(seed_for(seed, name)) {}
  double next() { return NormalNumber::of(dice_.bits()); }
  /// A factor about 1 that never comes near 0, however unlucky.
  double factor(double deviation) { return std::max(0.1, 1.0 + deviation * next()); }
  /// From 0 to 1.
  double share() { return static_cast<double>(dice_.bits() >> 11U) * (1.0 / 9007199254740992.0); }

 private:
  Dice dice_;
};

}  // namespace

Specimen::Specimen(const Hardware& hardware, const NoiseLevel& level, Size size, std::uint64_t seed)
    : level_(level), size_(size) {
  const Noise& noise = hardware.noise;
  frailty_ = exp_of(level.spread * Draws(seed, "frailty").next());
  const auto of = [&](NoiseGroup group, double deviation) { return this->level(group) * deviation; };
  Draws motors(seed, "motors"), tyres(seed, "tyres"), encoders(seed, "encoders"), beams(seed, "infrared");
  for (double& factor : motor) factor = motors.factor(of(NoiseGroup::motors, noise.motor_gain));
  stiffness = tyres.factor(of(NoiseGroup::tyres, noise.stiffness));
  grip = tyres.factor(of(NoiseGroup::tyres, noise.grip));
  for (double& factor : encoder) factor = encoders.factor(of(NoiseGroup::encoders, noise.encoder_scale));
  for (double& turns : ripple) turns = encoders.share();
  gyro = Draws(seed, "gyro").factor(of(NoiseGroup::gyro, noise.gyro_scale));
  for (double& factor : infrared) factor = beams.factor(of(NoiseGroup::infrared, noise.infrared_gain));

  const auto area = static_cast<std::size_t>(size.area());
  Draws walls(seed, "reflectance"), floor(seed, "floor");
  reflectances_.resize(4 * area);
  for (float& share : reflectances_)
    share = static_cast<float>(walls.factor(of(NoiseGroup::infrared, noise.reflectance)));
  if (noise.floor_steps <= 0.0) return;
  floor_steps_.resize(2 * area);
  for (FloorStep& step : floor_steps_) {
    const bool stands = floor.share() < noise.floor_steps;
    const double turn = floor.next(), shift = floor.next();
    if (stands)
      step = {of(NoiseGroup::floor, noise.floor_turn) * turn, of(NoiseGroup::floor, noise.floor_shift) * shift};
  }
}

double Specimen::reflectance(Cell cell, Heading side) const {
  return reflectances_[static_cast<std::size_t>(4 * size_.index(cell) + static_cast<int>(side))];
}

FloorStep Specimen::floor_step(Wall boundary) const {
  if (floor_steps_.empty() || !size_.contains(boundary.cell)) return {};
  return floor_steps_[static_cast<std::size_t>(2 * size_.index(boundary.cell) +
                                               (boundary.side == Heading::east ? 1 : 0))];
}

}  // namespace labmouse
