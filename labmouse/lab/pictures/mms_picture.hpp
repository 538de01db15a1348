// What a mouse of mms drew on its maze, and where it stands, for drawings.
#pragma once

#include <string>

#include "labmouse/external/mms/canvas.hpp"
#include "labmouse/external/mms/half_pose.hpp"
#include "labmouse/lab/drawing/drawing.hpp"

namespace labmouse {

/// Texts and colours of the mouse, and its place as near as a drawing of cells can show it.
DrawingLayers mms_layers(const MmsCanvas& canvas, const HalfPose& pose);

/// "at (3,0) heading north-east", in cells: (3.5,0) is between two of them.
std::string place_text(const HalfPose& pose);

}  // namespace labmouse
