#include "labmouse/lab/replays/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "labmouse/hardware/beam.hpp"
#include "labmouse/lab/pictures/trace_path.hpp"

namespace labmouse {
namespace {

constexpr double eighth = std::numbers::pi / 4.0;

double rounded(double value) { return std::round(value * 1e4) / 1e4; }

/// The heading, changed by whole turns (8 eighths) to be nearest to `other`.
double beside(double heading, double other) { return heading - 8.0 * std::round((heading - other) / 8.0); }

/// The distance, in cells, at which a wall at a right angle to the beam gives this reading; 0 if the reading is too
/// small.
double distance_of(std::int16_t level, const InfraredCurve& curve, double cell) {
  constexpr std::int16_t least = 5;
  if (level < least) return 0.0;
  return rounded(std::max(0.0, curve.distance(level)) / cell);
}

Json beams_json(const std::vector<Infrared>& sensors, double cell) {
  Json beams = Json::array();
  for (const Infrared& sensor : sensors)
    beams.push_back({{"ahead", rounded(sensor.beam.ahead / cell)},
                     {"left", rounded(sensor.beam.aside / cell)},
                     {"angle", rounded(-sensor.beam.angle / eighth)}});
  return beams;
}

Json looks_json(const std::vector<Look>& looks) {
  Json list = Json::array();
  for (const Look& look : looks)
    list.push_back({{"time", look.time},
                    {"x", look.pose.cell.x},
                    {"y", look.pose.cell.y},
                    {"heading", eighths(look.pose.heading)},
                    {"evidence", {look.evidence.left, look.evidence.ahead, look.evidence.right}}});
  return list;
}

Json touches_json(const DriveRecordFile& contest) {
  Json list = Json::array();
  for (const WallTouch& touch : contest.physical->notes.touches) {
    const DrivePathPoint at = touched_at(contest, touch);
    list.push_back({{"time", touch.time}, {"x", rounded(at.x)}, {"y", rounded(at.y)}, {"crash", touch.crash}});
  }
  return list;
}

}  // namespace

Json bodies_json(const DriveRecordFile& contest) {
  const double cell = contest.model->tables.cell;
  const Hardware& hardware = *contest.model->robot.hardware;
  const std::vector<Infrared>& infrared = hardware.sensors.infrared;
  std::vector<InfraredCurve> curves;
  for (const Infrared& sensor : infrared) curves.emplace_back(sensor, cell);
  const PhysicalNotes& notes = contest.physical->notes;
  std::vector<double> x, y, heading, distances;
  for (std::size_t i = 0; i < contest.record.runs.size(); ++i) {
    const std::vector<DrivePathPoint> truth = true_path(contest, i), estimate = believed_path(contest, i);
    for (std::size_t point = 0; point < estimate.size(); ++point) {
      x.push_back(rounded(estimate[point].x));
      y.push_back(rounded(estimate[point].y));
      heading.push_back(rounded(beside(estimate[point].heading, truth[point].heading)));
    }
    const DriveRun& run = contest.record.runs[i];
    for (const TracePoint& point : trace_of(contest, run))
      for (std::size_t sensor = 0; sensor < curves.size(); ++sensor)
        distances.push_back(distance_of(point.infrared[sensor], curves[sensor], cell));
  }
  const Chassis& chassis = hardware.chassis;
  return {{"front", rounded(chassis.front / cell)},
          {"back", rounded(chassis.back / cell)},
          {"half_width", rounded(chassis.half_width / cell)},
          {"rounding", rounded(chassis.rounding / cell)},
          {"belief", {{"x", x}, {"y", y}, {"heading", heading}}},
          {"beams", beams_json(infrared, cell)},
          {"distances", distances},
          {"looks", looks_json(notes.looks)},
          {"touches", touches_json(contest)}};
}

}  // namespace labmouse
