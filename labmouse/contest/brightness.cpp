#include "labmouse/contest/brightness.hpp"

namespace labmouse {

std::size_t brightness_class(const RobotSample& sample, const Pose& pose, Heading side, bool wall) {
  const auto of = [&](BeamPlace beam) { return sample.brightness(beam, pose.cell, side, wall); };
  if (side == left_of(pose.heading)) return brightness_class(of(BeamPlace::left));
  if (side == right_of(pose.heading)) return brightness_class(of(BeamPlace::right));
  return brightness_class((of(BeamPlace::left_ahead) + of(BeamPlace::right_ahead)) / 2.0);
}

}  // namespace labmouse
