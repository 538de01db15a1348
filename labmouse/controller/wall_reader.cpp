#include "labmouse/controller/wall_reader.hpp"

#include <algorithm>
#include <cmath>

#include "labmouse/functions/exponential.hpp"
#include "labmouse/functions/normal.hpp"
#include "labmouse/functions/whole.hpp"
#include "labmouse/hardware/beam.hpp"

namespace labmouse {
namespace {

/// Share of readings that the sensor model does not explain.
constexpr double odd_readings = 3e-4;
/// Log-odds of a wall (nats) are limited to the first; below the second there is no evidence.
constexpr double most_nats = 8.0, least_nats = 1.0;

/// Points (in standard deviations) and weights that approximate a normal distribution.
struct Trial {
  double deviations, weight;
};
constexpr std::array<Trial, 7> trials = {
    {{-3.0, 0.006}, {-2.0, 0.061}, {-1.0, 0.242}, {0.0, 0.382}, {1.0, 0.242}, {2.0, 0.061}, {3.0, 0.006}}};

Evidence evidence_of(double nats) {
  if (std::abs(nats) < least_nats) return 0;
  const double eighths = std::clamp(nats, -most_nats, most_nats) * evidence_a_nat;
  return static_cast<Evidence>(eighths < 0.0 ? eighths - 0.5 : eighths + 0.5);
}

/// Density of Student's t with three degrees of freedom, without its constant. Its heavy tails allow for unmodelled
/// errors.
double density(double error, double variance) {
  constexpr double freedom = 3.0;
  return 1.0 / (square(1.0 + square(error) / (freedom * variance)) * std::sqrt(variance));
}

}  // namespace

WallReader::WallReader(const Hardware& hardware, double cell)
    : hardware_(hardware), cell_(cell), views_(hardware.sensors.infrared, cell) {}

void WallReader::begin(const Pose& pose) {
  pose_ = pose;
  for (std::size_t beam = 0; beam < beam_count; ++beam) sights_[beam] = sight_of(beam, pose);
  front_ = line_on(pose.cell, pose.heading, right_of(pose.heading), cell_);
  stretches_ = {};
  ranged_ = 0.0;
}

WallReader::Sight WallReader::sight_of(std::size_t beam, const Pose& pose) const {
  const bool aside = views_.looks_aside(beam);
  const Heading side = !aside ? pose.heading : views_.looks_left(beam) ? left_of(pose.heading) : right_of(pose.heading);
  const Heading axis = aside ? pose.heading : right_of(pose.heading);
  const Position middle = {(pose.cell.x + 0.5) * cell_, (pose.cell.y + 0.5) * cell_};
  return {side, line_on(pose.cell, side, axis, cell_), dot(middle, way_in(axis)) - cell_ / 2.0};
}

void WallReader::read(const Sense& sense, const PoseEstimate& estimate) {
  if (!pose_) return;
  for (std::size_t beam = 0; beam < beam_count; ++beam) read_beam(beam, sense, estimate);
  if (sense.range_new) read_range(sense, estimate);
}

void WallReader::read_beam(std::size_t beam, const Sense& sense, const PoseEstimate& estimate) {
  const Sight& sight = sights_[beam];
  View view;
  if (!views_.see(beam, estimate.position, estimate.ahead, sight.line, view)) return;
  const double along = view.along - sight.begin;
  // Between the two posts; ahead, not farther than the front wall of a cell that the mouse enters.
  constexpr double first = 0.14, last = 0.86, far = 1.1, steep = 0.7;
  if (along < first * cell_ || along > last * cell_ || view.distance > far * cell_ || view.cosine < steep) return;
  Stretch& stretch = stretches_[beam];
  ++stretch.count;
  stretch.level += sense.infrared[beam];
  stretch.expected += views_.level_of(beam, view);
  stretch.along += along;
  stretch.view = view;
  stretch.ahead = estimate.ahead;
}

/// Adds the log-likelihood ratio of a ToF reading: with a wall ahead against without.
void WallReader::read_range(const Sense& sense, const PoseEstimate& estimate) {
  const Ranger& ranger = hardware_.sensors.ranger;
  const Position& on = front_.out;
  const double expected = front_.face - dot(estimate.position, on) - ranger.ahead;
  const double ahead = dot({estimate.ahead.cosine, estimate.ahead.sine}, on);
  constexpr double straight = 0.985, far = 1.2;
  if (ahead < straight || expected > far * cell_ || expected > ranger.reach || expected < 0.0) return;
  const double deviation2 =
      square(hardware_.noise.ranger) + square(0.01 * cell_) + estimate.variance_of(on.x, on.y, 0.0);
  const double odd = odd_readings / ranger.reach;
  double with = odd, without = odd;
  if (sense.range > 0) with += density(sense.range - expected, deviation2);
  // Without it the next wall is a cell farther, or too far to be seen.
  if (sense.range == 0 || sense.range > expected + cell_ / 2.0) without += 1.0 / ranger.reach;
  ranged_ = std::clamp(ranged_ + log_of(with / without), -most_nats, most_nats);
}

/// Share of a beam's spot on the two posts of an absent wall.
double WallReader::post_share(double along, double cosine) const {
  const double half = half_wall_of(cell_), deviation = hardware_.sensors.infrared.footprint / cosine;
  const auto below = [&](double point) { return NormalShare::below((point - along) / deviation); };
  return below(half) - below(-half) + below(cell_ + half) - below(cell_ - half);
}

/// Likelihood of a mean reading, given the expected one.
double WallReader::likelihood(double level, double expected) const {
  const Noise& noise = hardware_.noise;
  const double variance = reading_variance(hardware_.variation, expected) + square(noise.infrared_share * expected) +
                          square(noise.infrared) + 1.0;
  return density(level - expected, variance);
}

double WallReader::nats_of(std::size_t beam, const PoseEstimate& estimate) const {
  const Stretch& stretch = stretches_[beam];
  if (stretch.count == 0) return 0.0;
  const double level = stretch.level / stretch.count, expected = stretch.expected / stretch.count,
               along = stretch.along / stretch.count;
  const Infrared& infrared = hardware_.sensors.infrared;
  const ViewSlopes by = views_.slopes(beam, stretch.ahead, sights_[beam].line, stretch.view);
  // Limited to a cell: with a larger error the readings give no information.
  const auto deviation = [&](const std::array<double, 3>& slopes) {
    return std::min(cell_, std::sqrt(estimate.variance_of(slopes[0], slopes[1], slopes[2])));
  };
  const double off = deviation(by.distance), shifted = deviation(by.along);
  double with = 0.0, without = 0.0;
  for (const Trial& on : trials) {
    const double place = along + on.deviations * shifted;
    // Past the post, the spot is not on this wall; half of its reading is expected.
    const double wall = place < 0.0 || place > cell_ ? 0.5 : 1.0;
    const double posts = std::min(1.0, post_share(place, stretch.view.cosine));
    for (const Trial& aside : trials) {
      const double weight = aside.weight * on.weight;
      const double whole = expected * exp_of(-aside.deviations * off / infrared.fall);
      with += weight * likelihood(level, std::min(infrared.most, wall * whole));
      without += weight * likelihood(level, std::min(infrared.most, posts * whole));
    }
  }
  return log_of(with / without);
}

WallEvidence WallReader::evidence(const PoseEstimate& estimate) const {
  if (!pose_) return {};
  double left = 0.0, ahead = ranged_, right = 0.0;
  for (std::size_t beam = 0; beam < beam_count; ++beam) {
    const Heading side = sights_[beam].side;
    (side == pose_->heading ? ahead : side == left_of(pose_->heading) ? left : right) += nats_of(beam, estimate);
  }
  return {evidence_of(left), evidence_of(ahead), evidence_of(right)};
}

}  // namespace labmouse
