// The crash that ended a run of the physical or the failure model.
#pragma once

#include <cstddef>
#include <optional>

#include "labmouse/lab/pictures/drive_path.hpp"
#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/mouse/drive/search_motion.hpp"

namespace labmouse {

/// When and where a run crashed; nothing where it did not. `before`: in a search run or a way home, the place after its
/// last finished move. The physical world records the place. The failure model does not: there it follows from the
/// planned route in a speed run, and is the middle of the cell that the mouse was about to cross in other runs.
std::optional<DrivePathPoint> crash_of(const DriveRecordFile& file, std::size_t run, const SearchPlace& before);

/// The cell of a point.
Cell cell_of(const DrivePathPoint& point);

}  // namespace labmouse
