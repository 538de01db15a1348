// The path of a mouse in seconds as the data of an SVG path.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "labmouse/lab/drawing/frame.hpp"
#include "labmouse/lab/pictures/drive_path.hpp"

namespace labmouse::drawing {

/// A line through the points from `first` to `last`, which is among them.
std::string data_through(const Frame& frame, const std::vector<DrivePathPoint>& path, std::size_t first,
                         std::size_t last);

}  // namespace labmouse::drawing
