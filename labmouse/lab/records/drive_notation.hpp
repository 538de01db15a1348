// Routes in seconds as builders write them down.
#pragma once

#include <string>

#include "labmouse/mouse/robot/route.hpp"

namespace labmouse {

/// S3 is a straight of three half cells, D4 one over four half diagonals, and L45, R90, LV90
/// and RS90 are turns to the left and right.
std::string notation_of(const DriveSegment& segment, const DriveTables& tables);
/// Of all segments, with blanks between; a straight that is but the lead of a turn is left out.
std::string notation_of(const DriveRoute& route, const DriveTables& tables);

}  // namespace labmouse
