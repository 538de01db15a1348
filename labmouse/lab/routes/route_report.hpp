// The fastest route of a maze, compared with routes without diagonals and with the fewest cells.
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

/// The fastest route of one maze, and others to compare it with.
struct RouteReport {
  std::string error;  ///< why there is no route; the other fields are then invalid
  DriveRoute route;
  DriveTime gate_to_gate = 0;  ///< time of the route from leaving the start cell to entering a goal, microseconds
  int cells = 0;               ///< number of cells that the route enters
  /// Time of the fastest route without diagonals: straights along the axes and the turns between them.
  DriveTime without_diagonals = no_time;
  /// Time of the fastest route with S90, the small turns of a search, as its only turns.
  DriveTime small_turns = no_time;
  int fewest_cells = 0;  ///< smallest number of cells that any route enters
  /// Time of the fastest route that enters only `fewest_cells` cells. It is planned through the passages of all such
  /// routes; nothing where the planned route still enters more cells.
  std::optional<DriveTime> fewest_cells_time;

  /// The share of another route's time that this route saves; nothing where `other` is 0 or no_time.
  std::optional<double> gain_over(DriveTime other) const;
};

/// Makes reports for many mazes; keeps what their plans share.
class RouteReporter {
 public:
  /// The model must outlive it.
  explicit RouteReporter(const DriveModel& model);

  /// Reports an error for a maze too large for the world in seconds, and for one without a route in the direction of
  /// its start.
  RouteReport report(const Maze& maze) const;

 private:
  const DriveModel& model_;
  std::shared_ptr<const RouteTables> all_, without_diagonals_, small_turns_;
};

/// Reports on one maze.
inline RouteReport route_report(const Maze& maze, const DriveModel& model) { return RouteReporter(model).report(maze); }

/// The route as a table of its segments, and its comparisons.
std::string table_of(const RouteReport& report, const NamedMaze& maze, const DriveModel& model);

/// A line for each maze, then medians. Mazes without a route have a reason in place of numbers.
std::string summary_of(const std::vector<RouteReport>& reports, const std::vector<NamedMaze>& mazes,
                       const DriveModel& model);

/// All routes with their segments, as JSON.
std::string json_of(const std::vector<RouteReport>& reports, const std::vector<NamedMaze>& mazes,
                    const DriveModel& model);

}  // namespace labmouse
