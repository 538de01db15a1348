// Layers for drawings of mms contests: texts and colours set by the mouse, and its pose.
#pragma once

#include <string>

#include "labmouse/external/mms/canvas.hpp"
#include "labmouse/external/mms/half_pose.hpp"
#include "labmouse/lab/drawing/drawing.hpp"

namespace labmouse {

/// Texts and colours set by the mouse, and its pose, rounded to a cell and one of four headings.
DrawingLayers mms_layers(const MmsCanvas& canvas, const HalfPose& pose);

/// "at (3,0) heading north-east", in cells; (3.5,0) is the edge between two cells.
std::string place_text(const HalfPose& pose);

}  // namespace labmouse
