// Record of one contest in the physical world or the failure model: that of a contest in seconds, and true and
// estimated poses, sensor readings and wall touches.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "labmouse/contest/controller_code.hpp"
#include "labmouse/contest/drive_record.hpp"
#include "labmouse/functions/position.hpp"
#include "labmouse/mouse/evidence.hpp"

namespace labmouse {

/// How a run ended.
enum class RunEnd : std::uint8_t {
  done,           ///< successfully: in a goal, or at home
  given_up,       ///< the strategy had no more to do in it
  slid,           ///< a crash because the tyres did not hold
  position_lost,  ///< a crash because of a localization or tracking error
  wall_error,     ///< a crash into a wall that it had read as open
  no_route_left,  ///< its map had no route left, or did not fit the readings
  out_of_time,
};

/// All ends, in the order of the enumeration.
inline constexpr std::array all_run_ends = {RunEnd::done,          RunEnd::given_up,   RunEnd::slid,
                                            RunEnd::position_lost, RunEnd::wall_error, RunEnd::no_route_left,
                                            RunEnd::out_of_time};

/// The name of an end, for records and tables.
/// @param end one of all_run_ends.
/// @return in static memory.
constexpr std::string_view name_of(RunEnd end) {
  constexpr std::array<std::string_view, all_run_ends.size()> names = {
      "done", "given up", "slid", "position lost", "wall error", "no route left", "out of time"};
  return names[static_cast<std::size_t>(end)];
}

/// Whether a run ended by a crash: slid, position lost or wall error.
/// @param end how it ended.
constexpr bool is_crash(RunEnd end) {
  return end == RunEnd::slid || end == RunEnd::position_lost || end == RunEnd::wall_error;
}

/// A mouse in the plane: where it is in mm, and where it points, in rad to the left of east.
struct BodyPose {
  Position position;
  double angle = 0.0;

  friend bool operator==(const BodyPose&, const BodyPose&) = default;
};

/// One trace point: the true and the estimated pose.
struct TracePoint {
  MazeTime time = 0;
  BodyPose truth;
  std::optional<BodyPose> estimate;    ///< none for an external controller
  std::vector<std::int16_t> infrared;  ///< counts of each sensor

  friend bool operator==(const TracePoint&, const TracePoint&) = default;
};

/// Evidence of the walls around a cell, at its entry.
struct Look {
  MazeTime time = 0;
  Pose pose;
  WallEvidence evidence;

  friend bool operator==(const Look&, const Look&) = default;
};

/// A touch of a wall, with or without a crash.
struct WallTouch {
  MazeTime time = 0;
  BodyPose at;
  bool crash = false;

  friend bool operator==(const WallTouch&, const WallTouch&) = default;
};

/// What a contest in the physical world adds to one in seconds.
struct PhysicalNotes {
  std::vector<RunEnd> ends;  ///< one per run
  std::vector<Look> looks;
  std::vector<WallTouch> touches;
  std::vector<TracePoint> trace;     ///< at the interval asked for, if any
  std::vector<Action> actions;       ///< all decisions of the strategy, in order
  std::vector<ControllerTick> tape;  ///< instead of actions: the output of an external controller, tick by tick
  bool foreign_parts = false;        ///< whether parts of the controller were external
  bool by_failure_model = false;     ///< whether it was run in the failure model
  int carried = 0;                   ///< how often it was carried to the start
  int wrong_walls = 0;               ///< walls classified wrongly
  int contradictions = 0;            ///< readings that contradicted the map
  double severity = 0.0;             ///< RobotSample::severity(), in standard deviations

  friend bool operator==(const PhysicalNotes&, const PhysicalNotes&) = default;
};

/// One contest of one mouse in one maze, in a world with errors.
struct PhysicalRecord : PhysicalNotes {
  /// Runs, walls as classified by the mouse, and decisions. Times of gates are those of the true mouse.
  DriveRecord drive;

  friend bool operator==(const PhysicalRecord&, const PhysicalRecord&) = default;
};

}  // namespace labmouse
