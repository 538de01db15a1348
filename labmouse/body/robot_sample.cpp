#include "labmouse/body/robot_sample.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
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

/// Builders notice and replace a motor that is more than a fifth off: its logarithm is limited to that of 0.8 and 1.2.
double motor_factor_of(double logarithm) { return std::clamp(factor_of(logarithm), 0.8, 1.2); }

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

RobotSample::RobotSample(const Hardware& hardware, const ErrorScale& scale, Size size, std::uint64_t seed)
    : infrared(hardware.sensors.infrared.size()), ambient(infrared.size()), scale_(scale), size_(size) {
  for (const Infrared& sensor : hardware.sensors.infrared) looks_.push_back(side_of(sensor.beam));
  const Variation& variation = hardware.variation;
  double fourth_powers = 0.0;
  int drawn = 0;
  // A number of the mouse itself, in standard deviations.
  const auto own = [&](Draws& draws, ErrorCause cause) {
    const double off = scale.variation_of(cause) * draws.next();
    fourth_powers += square(square(off));
    ++drawn;
    return off;
  };
  Draws motors(seed, "motors"), batteries(seed, "battery"), tyres(seed, "tyres"), encoders(seed, "encoders"),
      gyros(seed, "gyro"), accelerometers(seed, "acceleration"), beams(seed, "infrared"), lights(seed, "ambient light");
  for (double& factor : motor) factor = motor_factor_of(own(motors, ErrorCause::motors) * variation.motor_gain);
  battery =
      std::max(0.0, 1.0 - scale.variation_of(ErrorCause::motors) * variation.battery * std::abs(batteries.next()));
  stiffness = factor_of(own(tyres, ErrorCause::tyres) * variation.stiffness);
  grip = factor_of(own(tyres, ErrorCause::tyres) * variation.grip);
  for (double& factor : encoder)
    factor = encoders.factor(scale.variation_of(ErrorCause::encoders) * variation.encoder_scale);
  for (double& turns : ripple) turns = encoders.unit();
  gyro = factor_of(own(gyros, ErrorCause::gyro) * variation.gyro_scale);
  for (double& offset : acceleration)
    offset = scale.variation_of(ErrorCause::accelerometer) * variation.acceleration_bias * accelerometers.next();
  for (double& factor : infrared) factor = factor_of(own(beams, ErrorCause::infrared) * variation.infrared_gain);
  for (double& counts : ambient)
    counts = scale.variation_of(ErrorCause::ambient) * variation.ambient * std::abs(lights.next());
  severity_ = std::sqrt(std::sqrt(fourth_powers / drawn));
  draw_maze(variation, seed);
}

void RobotSample::draw_maze(const Variation& variation, std::uint64_t seed) {
  const auto area = static_cast<std::size_t>(size_.area());
  const double shine = scale_.variation_of(ErrorCause::reflectance), floor = scale_.variation_of(ErrorCause::floor),
               dust = scale_.variation_of(ErrorCause::tyres) * variation.dust,
               shift = scale_.variation_of(ErrorCause::posts) * variation.post_shift;
  Draws walls(seed, "reflectance"), paint(seed, "maze reflectance"), steps(seed, "floor"), tilts(seed, "floor tilt"),
      dusts(seed, "dust"), posts(seed, "posts");
  maze_reflectance_ = paint.factor(shine * variation.maze_reflectance);
  reflectances_.resize(4 * area);
  for (float& share : reflectances_)
    share = static_cast<float>(maze_reflectance_ * walls.factor(shine * variation.reflectance));
  if (variation.floor_steps > 0.0) {
    floor_steps_.resize(2 * area);
    for (FloorStep& step : floor_steps_) {
      const bool stands = steps.unit() < variation.floor_steps;
      const double turn = steps.next(), aside = steps.next();
      if (stands) step = {floor * variation.floor_turn * turn, floor * variation.floor_shift * aside};
    }
  }
  if (floor * variation.floor_tilt > 0.0 || dust > 0.0) {
    floors_.resize(area);
    for (Floor& cell : floors_) {
      cell.slope.x = floor * variation.floor_tilt * tilts.next();
      cell.slope.y = floor * variation.floor_tilt * tilts.next();
      // Dust takes grip and never adds any.
      cell.grip = factor_of(-dust * std::abs(dusts.next()));
    }
  }
  if (shift > 0.0) {
    post_shifts_.resize(static_cast<std::size_t>((size_.width + 1) * (size_.height + 1)));
    for (Position& post : post_shifts_) {
      // Farther off it would be put right.
      constexpr double most = 4.0 / 3.0;  // standard deviations
      post.x = shift * std::clamp(posts.next(), -most, most);
      post.y = shift * std::clamp(posts.next(), -most, most);
    }
  }
}

double RobotSample::brightness() const {
  if (infrared.empty()) return maze_reflectance_;
  return maze_reflectance_ * std::accumulate(infrared.begin(), infrared.end(), 0.0) /
         static_cast<double>(infrared.size());
}

double RobotSample::brightness(BeamSide looks, Cell cell, Heading side, bool wall) const {
  double sum = 0.0;
  int sensors = 0;
  for (std::size_t i = 0; i < looks_.size(); ++i)
    if (looks_[i] == looks) {
      sum += infrared[i];
      ++sensors;
    }
  return (sensors > 0 ? sum / sensors : 1.0) * (wall ? reflectance(cell, side) : maze_reflectance_);
}

double RobotSample::reflectance(Cell cell, Heading side) const {
  return reflectances_[static_cast<std::size_t>(4 * size_.index(cell) + static_cast<int>(side))];
}

FloorStep RobotSample::floor_step(Wall boundary) const {
  if (floor_steps_.empty() || !size_.contains(boundary.cell)) return {};
  return floor_steps_[static_cast<std::size_t>(2 * size_.index(boundary.cell) +
                                               (boundary.side == Heading::east ? 1 : 0))];
}

Floor RobotSample::floor(Cell cell) const {
  if (floors_.empty() || !size_.contains(cell)) return {};
  return floors_[static_cast<std::size_t>(size_.index(cell))];
}

}  // namespace labmouse
