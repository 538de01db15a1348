// What happened in one contest in the physical world, by the clock of the maze: what a contest in seconds is told by,
// and beside it where the mouse was, where it believed to be, what its sensors said, and what it touched.
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
  done,           ///< as it should: in a goal, or at home
  given_up,       ///< the strategy had no more to do in it
  slid,           ///< a crash because the tyres did not hold
  position_lost,  ///< a crash because the mouse was not where it believed to be, or not where it should be
  wall_error,     ///< a crash into a wall that it had read as open
  no_route_left,  ///< its map had no way left, or did not fit what it saw
  out_of_time,
};

inline constexpr std::array all_run_ends = {RunEnd::done,          RunEnd::given_up,   RunEnd::slid,
                                            RunEnd::position_lost, RunEnd::wall_error, RunEnd::no_route_left,
                                            RunEnd::out_of_time};

constexpr std::string_view name_of(RunEnd end) {
  constexpr std::array<std::string_view, all_run_ends.size()> names = {
      "done", "given up", "slid", "position lost", "wall error", "no route left", "out of time"};
  return names[static_cast<std::size_t>(end)];
}

constexpr bool is_crash(RunEnd end) {
  return end == RunEnd::slid || end == RunEnd::position_lost || end == RunEnd::wall_error;
}

/// A mouse in the plane: where it is in mm, and where it points, in rad to the left of east.
struct BodyPose {
  Position position;
  double angle = 0.0;

  friend bool operator==(const BodyPose&, const BodyPose&) = default;
};

/// One moment of both mice, the true one and the one that it thinks it is.
struct TracePoint {
  MazeTime time = 0;
  BodyPose truth;
  std::optional<BodyPose> estimate;  ///< nothing of a mouse whose program does not tell
  std::array<std::int16_t, 4> infrared{};

  friend bool operator==(const TracePoint&, const TracePoint&) = default;
};

/// What the sensors said of the walls about a cell as it was entered.
struct Look {
  MazeTime time = 0;
  Pose pose;
  WallEvidence evidence;

  friend bool operator==(const Look&, const Look&) = default;
};

/// A touch of a wall that the run survived, or not.
struct WallTouch {
  MazeTime time = 0;
  BodyPose at;
  bool crash = false;

  friend bool operator==(const WallTouch&, const WallTouch&) = default;
};

/// What a contest in the physical world adds to one in seconds.
struct PhysicalNotes {
  std::vector<RunEnd> ends;  ///< of each run
  std::vector<Look> looks;
  std::vector<WallTouch> touches;
  std::vector<TracePoint> trace;     ///< every so often, where it was asked for
  std::vector<Action> actions;       ///< all decisions of the strategy, in order
  std::vector<ControllerTick> tape;  ///< in place of these, what a program of somebody else's said, tick by tick
  bool foreign_parts = false;        ///< whether parts of the controller were somebody else's
  bool by_dice = false;              ///< whether it was held in the failure model
  int carried = 0;                   ///< how often a hand took it to the start
  int wrong_walls = 0;               ///< walls that it took for what they are not
  int contradictions = 0;            ///< readings against what it had taken a wall for
  double severity = 0.0;  ///< how unlucky the draws of this contest were, in deviations: RobotSample::severity()

  friend bool operator==(const PhysicalNotes&, const PhysicalNotes&) = default;
};

struct PhysicalRecord : PhysicalNotes {
  /// Runs, walls as the mouse took them, and decisions. Times of gates are those of the true mouse.
  DriveRecord drive;

  friend bool operator==(const PhysicalRecord&, const PhysicalRecord&) = default;
};

}  // namespace labmouse
