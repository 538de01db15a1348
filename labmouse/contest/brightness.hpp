// Classes of how bright walls look to a mouse, by which failure rates are counted.
//
// Mice detect walls by the light that these reflect, so most failures come from sensors and walls that are darker or
// brighter than the controller expects. A wall that looks dark to a mouse stays dark for the whole contest.
#pragma once

#include <array>
#include <cstddef>

#include "labmouse/body/robot_sample.hpp"
#include "labmouse/mouse/pose.hpp"

namespace labmouse {

/// Upper limits of the classes but the last, as factors of the nominal brightness.
inline constexpr std::array<double, 7> brightness_limits = {0.4, 0.5, 0.6, 0.75, 1.0, 1.4, 2.0};
inline constexpr std::size_t brightness_classes = brightness_limits.size() + 1;

constexpr std::size_t brightness_class(double brightness) {
  std::size_t place = 0;
  while (place < brightness_limits.size() && brightness >= brightness_limits[place]) ++place;
  return place;
}

/// The class of a reading in that pose, of the wall or the gap on that side of the cell.
std::size_t brightness_class(const RobotSample& sample, const Pose& pose, Heading side, bool wall);

}  // namespace labmouse
