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
    : hardware_(hardware),
      cell_(cell),
      views_(hardware.sensors.infrared, cell),
      sights_(hardware.sensors.infrared.size()),
      stretches_(sights_.size()),
      ranged_(hardware.sensors.rangers.size()) {
  for (const Ranger& ranger : hardware.sensors.rangers) mounts_.push_back(mount_of(ranger));
}

void WallReader::begin(const Pose& pose) {
  pose_ = pose;
  for (std::size_t i = 0; i < sights_.size(); ++i) sights_[i] = sight_of(views_.side(i), pose);
  std::fill(stretches_.begin(), stretches_.end(), Stretch());
  std::fill(ranged_.begin(), ranged_.end(), 0.0);
}

WallReader::Sight WallReader::sight_of(BeamSide side, const Pose& pose) const {
  const Heading wall = side_in(pose.heading, side);
  const Heading axis = side == BeamSide::ahead ? right_of(pose.heading) : pose.heading;
  const Position middle = {(pose.cell.x + 0.5) * cell_, (pose.cell.y + 0.5) * cell_};
  return {line_on(pose.cell, wall, axis, cell_), dot(middle, way_in(axis)) - cell_ / 2.0};
}

void WallReader::read(const Sense& sense, const PoseEstimate& estimate) {
  if (!pose_) return;
  for (std::size_t i = 0; i < sights_.size(); ++i) read_infrared(i, sense, estimate);
  for (std::size_t i = 0; i < ranged_.size(); ++i)
    if (sense.ranges[i].is_new) read_range(i, sense.ranges[i], estimate);
}

void WallReader::read_infrared(std::size_t sensor, const Sense& sense, const PoseEstimate& estimate) {
  const Sight& sight = sights_[sensor];
  View view;
  if (!views_.see(sensor, estimate.position, estimate.ahead, sight.line, view)) return;
  const double along = view.along - sight.begin;
  // Between the two posts; ahead, not farther than the front wall of a cell that the mouse enters.
  constexpr double first = 0.14, last = 0.86, far = 1.1, usual_steep = 0.7, share = 0.78;
  const double steep = std::min(usual_steep, share * views_.cosine_in_line(sensor));
  if (along < first * cell_ || along > last * cell_ || view.distance > far * cell_ || view.cosine < steep) return;
  Stretch& stretch = stretches_[sensor];
  ++stretch.count;
  stretch.level += sense.infrared[sensor];
  stretch.expected += views_.level_of(sensor, view);
  stretch.along += along;
  stretch.view = view;
  stretch.ahead = estimate.ahead;
}

/// Adds the log-likelihood ratio of a ToF reading: with a wall against without.
void WallReader::read_range(std::size_t sensor, const RangeSense& seen, const PoseEstimate& estimate) {
  const RangerMount& mount = mounts_[sensor];
  const double reach = hardware_.sensors.rangers[sensor].reach;
  const Heading side = side_in(pose_->heading, mount.side);
  const WallLine line = line_on(pose_->cell, side, right_of(side), cell_);
  const Position& on = line.out;
  const double expected = (line.face - dot(estimate.position, on) - mount.depth) / mount.cosine;
  const double in_line = dot({estimate.ahead.cosine, estimate.ahead.sine}, way_in(pose_->heading));
  constexpr double straight = 0.985, far = 1.2;
  if (in_line < straight || expected > far * cell_ || expected > reach || expected < 0.0) return;
  if (mount.side != BeamSide::ahead && !passes_middle(sensor, expected, estimate)) return;
  const double deviation2 = square(hardware_.noise.ranger) + square(0.01 * cell_) +
                            estimate.variance_of(on.x, on.y, 0.0) / square(mount.cosine);
  const double odd = odd_readings / reach;
  double with = odd, without = odd;
  if (seen.distance > 0) with += density(seen.distance - expected, deviation2);
  // Without it the next wall is a cell farther, or too far to be seen.
  if (seen.distance == 0 || seen.distance > expected + cell_ / 2.0) without += 1.0 / reach;
  ranged_[sensor] = std::clamp(ranged_[sensor] + log_of(with / without), -most_nats, most_nats);
}

/// Whether a ToF sensor that looks aside meets the wall between its two posts.
bool WallReader::passes_middle(std::size_t sensor, double distance, const PoseEstimate& estimate) const {
  const RangerMount& mount = mounts_[sensor];
  const Position axis = way_in(pose_->heading);
  const Position middle = {(pose_->cell.x + 0.5) * cell_, (pose_->cell.y + 0.5) * cell_};
  const double along = dot(estimate.position, axis) + mount.along + distance * mount.along_cosine;
  constexpr double most = 0.36;
  return std::abs(along - dot(middle, axis)) < most * cell_;
}

/// Share of a spot with that deviation (mm) on the two posts of an absent wall.
double WallReader::post_share(double along, double deviation) const {
  const double half = half_wall_of(cell_);
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

double WallReader::nats_of(std::size_t sensor, const PoseEstimate& estimate) const {
  const Stretch& stretch = stretches_[sensor];
  if (stretch.count == 0) return 0.0;
  const double level = stretch.level / stretch.count, expected = stretch.expected / stretch.count,
               along = stretch.along / stretch.count;
  const Infrared& infrared = hardware_.sensors.infrared[sensor];
  const double fall = views_.fall_of(sensor, stretch.view), spot = infrared.footprint / stretch.view.cosine;
  const ViewSlopes by = views_.slopes(sensor, stretch.ahead, sights_[sensor].line, stretch.view);
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
    const double posts = std::min(1.0, post_share(place, spot));
    for (const Trial& aside : trials) {
      const double weight = aside.weight * on.weight;
      constexpr double most = 100.0;
      const double whole = expected * exp_of(std::clamp(-aside.deviations * off / fall, -most, most));
      with += weight * likelihood(level, std::min(infrared.most, wall * whole));
      without += weight * likelihood(level, std::min(infrared.most, posts * whole));
    }
  }
  return log_of(with / without);
}

WallEvidence WallReader::evidence(const PoseEstimate& estimate) const {
  if (!pose_) return {};
  std::array<double, 3> nats{};
  for (std::size_t i = 0; i < ranged_.size(); ++i) nats[static_cast<std::size_t>(mounts_[i].side)] += ranged_[i];
  for (std::size_t i = 0; i < sights_.size(); ++i)
    nats[static_cast<std::size_t>(views_.side(i))] += views_.share_of(i) * nats_of(i, estimate);
  const auto of = [&](BeamSide side) { return evidence_of(nats[static_cast<std::size_t>(side)]); };
  return {of(BeamSide::left), of(BeamSide::ahead), of(BeamSide::right)};
}

}  // namespace labmouse
