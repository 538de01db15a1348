#include "labmouse/lab/replays/crash.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "labmouse/lab/pictures/trace_path.hpp"
#include "labmouse/mouse/robot/drive_profile.hpp"

namespace labmouse {
namespace {

/// The place of the crash of a speed run or a run of laps, in the segment of its route that it did not finish.
std::optional<DrivePathPoint> crash_on_route(const DriveRecordFile& file, const DriveRun& run) {
  const double driven = static_cast<double>(run.end - run.begin) * pace_of(file, run);
  const auto& segments = run.route.segments;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (driven > static_cast<double>(segments[i].end) && i + 1 < segments.size()) continue;
    const DriveProfile profile(*file.model, run.route, i);
    const double within =
        std::clamp(driven - static_cast<double>(segments[i].begin), 0.0, static_cast<double>(profile.duration()));
    const DriveSpot spot = profile.spot(profile.distance_at(within));
    const double cell = file.model->tables.cell;
    return DrivePathPoint{static_cast<double>(run.end),
                          spot.x / cell,
                          spot.y / cell,
                          spot.angle * 4.0 / std::numbers::pi,
                          profile.speed_at(within) * pace_of(file, run),
                          0.0};
  }
  return std::nullopt;
}

}  // namespace

Cell cell_of(const DrivePathPoint& point) {
  return {static_cast<int>(std::floor(point.x)), static_cast<int>(std::floor(point.y))};
}

std::optional<DrivePathPoint> crash_of(const DriveRecordFile& file, std::size_t index, const SearchPlace& before) {
  if (!file.physical) return std::nullopt;
  const PhysicalNotes& notes = file.physical->notes;
  const DriveRun& run = file.record.runs[index];
  if (const WallTouch* touch = crash_in(file, run)) return touched_at(file, *touch);
  if (!notes.by_failure_model || index >= notes.ends.size() || !is_crash(notes.ends[index])) return std::nullopt;
  if (run.has_route())
    if (const auto crash = crash_on_route(file, run)) return crash;
  const Cell cell = before.pose.cell;
  return DrivePathPoint{.time = static_cast<double>(run.end),
                        .x = cell.x + 0.5,
                        .y = cell.y + 0.5,
                        .heading = static_cast<double>(eighths(before.pose.heading))};
}

}  // namespace labmouse
