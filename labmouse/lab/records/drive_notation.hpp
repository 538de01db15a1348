// Routes in seconds as builders write them down.
#pragma once

#include <string>

#include "labmouse/mouse/robot/route.hpp"

namespace labmouse {

/// The notation of one segment: S3 is a straight of three half cells, D4 a diagonal of four half diagonals, and L45,
/// R90, LV90 and RS90 are turns to the left and right.
std::string notation_of(const DriveSegment& segment, const DriveTables& tables);
/// The notation of all segments, separated by blanks. Straights of no length before or after a turn are left out.
std::string notation_of(const DriveRoute& route, const DriveTables& tables);

}  // namespace labmouse
