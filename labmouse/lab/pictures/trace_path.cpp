#include "labmouse/lab/pictures/trace_path.hpp"

#include <cmath>
#include <numbers>

namespace labmouse {
namespace {

DrivePathPoint point_at(const DriveRecordFile& file, MazeTime time, const BodyPose& pose) {
  const double cell = file.model->tables.cell;
  DrivePathPoint point;
  point.time = static_cast<double>(time);
  point.x = pose.position.x / cell;
  point.y = pose.position.y / cell;
  // In eighths of a turn clockwise from north.
  point.heading = (std::numbers::pi / 2.0 - pose.angle) / (std::numbers::pi / 4.0);
  return point;
}

/// Sets the speeds, in mm/s, by the distance to the next point.
void set_speeds(std::vector<DrivePathPoint>& points, double cell) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double seconds = (points[i + 1].time - points[i].time) / 1e6;
    const double way = std::hypot(points[i + 1].x - points[i].x, points[i + 1].y - points[i].y) * cell;
    points[i].speed = seconds > 0.0 ? way / seconds : 0.0;
  }
  if (points.size() > 1) points.back().speed = points[points.size() - 2].speed;
}

/// @param pose Returns the true or the estimated pose of a trace point, if it has one.
template <class PoseOf>
std::vector<DrivePathPoint> path_of(const DriveRecordFile& file, std::size_t index, PoseOf pose) {
  const DriveRun& run = file.record.runs[index];
  std::vector<DrivePathPoint> points;
  for (const TracePoint& point : trace_of(file, run))
    if (const std::optional<BodyPose> at = pose(point)) points.push_back(point_at(file, point.time, *at));
  set_speeds(points, file.model->tables.cell);
  return points;
}

}  // namespace

const WallTouch* crash_in(const DriveRecordFile& file, const DriveRun& run) {
  for (const WallTouch& touch : file.physical->notes.touches)
    if (touch.crash && touch.time == run.end) return &touch;
  return nullptr;
}

std::vector<TracePoint> trace_of(const DriveRecordFile& file, const DriveRun& run) {
  std::vector<TracePoint> points;
  for (const TracePoint& point : file.physical->notes.trace)
    if (point.time >= run.begin && point.time <= run.end) points.push_back(point);
  const WallTouch* crash = crash_in(file, run);
  if (crash != nullptr && !points.empty() && points.back().time < crash->time) {
    TracePoint last = points.back();
    last.time = crash->time;
    last.truth = crash->at;
    points.push_back(last);
  }
  return points;
}

std::vector<DrivePathPoint> true_path(const DriveRecordFile& file, std::size_t run) {
  return path_of(file, run, [](const TracePoint& point) { return std::optional(point.truth); });
}

std::vector<DrivePathPoint> believed_path(const DriveRecordFile& file, std::size_t run) {
  return path_of(file, run, [](const TracePoint& point) { return point.estimate; });
}

DrivePathPoint touched_at(const DriveRecordFile& file, const WallTouch& touch) {
  return point_at(file, touch.time, touch.at);
}

}  // namespace labmouse
