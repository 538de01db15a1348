#include "labmouse/contest/brightness.hpp"

namespace labmouse {

std::size_t brightness_class(const RobotSample& sample, const Pose& pose, Heading side, bool wall) {
  const BeamSide looks = side == left_of(pose.heading)    ? BeamSide::left
                         : side == right_of(pose.heading) ? BeamSide::right
                                                          : BeamSide::ahead;
  return brightness_class(sample.brightness(looks, pose.cell, side, wall));
}

}  // namespace labmouse
