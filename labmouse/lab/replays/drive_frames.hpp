// The lists of a play in seconds: a frame where each move or segment begins, and one at the end.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "labmouse/lab/pictures/drive_path.hpp"
#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

struct DriveRunFrames {
  std::size_t first = 0;  ///< the frame with which it begins
  std::optional<DrivePathPoint> crash;
};

/// Adds the lists of frames, steps and walls, and `goal_frame` and `reset_frame`. Returns the first frame and the
/// crash of each run.
std::vector<DriveRunFrames> add_drive_frames(const DriveRecordFile& contest, Json& play);

/// A segment in words: "ahead 2.5", "diagonal 3", "left 45", "right V90"; lengths in cells, of a diagonal in half
/// diagonals.
std::string segment_words(const DriveSegment& segment, const DriveTables& tables);

}  // namespace labmouse
