// What the map of a real robot says of its fastest run: the route that it knows, and the best that it may hope for.
#pragma once

#include <memory>
#include <string>

#include "labmouse/lab/live/live_map.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// Two routes from the start to a goal.
struct LivePlan {
  DriveRoute known;          ///< the fastest through openings that were seen; its time is no_time if there is none
  DriveTime hope = no_time;  ///< the time of the fastest if all walls that were not seen are open
  /// Whether no wall that was not seen can make the run faster.
  bool is_certain() const { return known.time < no_time && known.time <= hope; }
};

/// Plans as the map grows.
class LivePlanner {
 public:
  /// @param model of the robot; it must outlive the planner.
  explicit LivePlanner(const DriveModel& model);

  /// The routes of a map of at most max_drive_side cells a side.
  LivePlan plan(const PartialMap& map) const;

  /// What the robot may do now: "the known route takes 6.410 s, the best hope 6.120 s", or "..., and no unseen wall can
  /// make it faster: time to return".
  std::string text_of(const LivePlan& plan) const;

  /// The line that tells the robot the known route: "plan S3 R90 D4 *2f", with a line feed; empty if no route is known.
  /// The segments are those of `labmouse route`.
  std::string line_of(const LivePlan& plan) const;

 private:
  const DriveModel& model_;
  std::shared_ptr<const RouteTables> tables_;
};

}  // namespace labmouse
