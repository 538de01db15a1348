// The fastest route of a maze, and what its diagonals and its way are worth.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/records/drive_notation.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/robot/route.hpp"

namespace labmouse {

/// The fastest route of one maze, beside others.
struct RouteReport {
  std::string error;  ///< why there is none; then nothing else counts
  DriveRoute route;
  DriveTime gate_to_gate = 0;  ///< of the route: from leaving the start cell to entering a goal, microseconds
  int cells = 0;               ///< that the route enters
  /// The fastest route without diagonals, of straights along the axes and the turns between them.
  DriveTime without_diagonals = no_time;
  /// The same with the small turns of a search alone, S90.
  DriveTime small_turns = no_time;
  int fewest_cells = 0;  ///< that any route enters
  /// The fastest route over passages that lie on routes of the fewest cells; nothing where that one enters more of
  /// them.
  std::optional<DriveTime> fewest_cells_time;

  /// The share of another route's time that this one saves; nothing where there is none, or no time passes.
  std::optional<double> gain_over(DriveTime other) const;
};

/// What is looked for in every maze, with what the searches for it share.
class RouteReporter {
 public:
  /// The model must outlive it.
  explicit RouteReporter(const DriveModel& model);

  /// A maze too large for the world of seconds, and one without a route in the direction of its start, give an error.
  RouteReport report(const Maze& maze) const;

 private:
  const DriveModel& model_;
  std::shared_ptr<const RouteTables> all_, without_diagonals_, small_turns_;
};

/// Of one maze.
inline RouteReport route_report(const Maze& maze, const DriveModel& model) { return RouteReporter(model).report(maze); }

/// The route as a table of its segments, and how it compares.
std::string table_of(const RouteReport& report, const NamedMaze& maze, const DriveModel& model);

/// The routes of many mazes: a line each, then medians. Those without a route have a reason in place of numbers.
std::string summary_of(const std::vector<RouteReport>& reports, const std::vector<NamedMaze>& mazes,
                       const DriveModel& model);

/// All of the routes, with their segments.
std::string json_of(const std::vector<RouteReport>& reports, const std::vector<NamedMaze>& mazes,
                    const DriveModel& model);

}  // namespace labmouse
