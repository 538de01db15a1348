// Which route wins for which robot: one number of a robot file is varied, or two, and the regions are found in which
// one route stays the fastest.
//
// Method: plans at evenly spaced values; between neighbours whose routes differ, bisection, which finds the routes in
// between, until the two sides of a border are as close as asked for. Of two numbers the second is stepped through: a
// row of regions at each of its values.
// Limits: a region that lies between two evenly spaced values of one route is missed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/robots/robot_family.hpp"
#include "labmouse/lab/routes/varied_number.hpp"
#include "labmouse/mouse/robot/route.hpp"

namespace labmouse {

struct RegionOrder {
  VariedNumber across;
  std::optional<VariedNumber> along;
  int samples = 33;         ///< evenly spaced values of `across`, 2 or more
  int rows = 1;             ///< evenly spaced values of `along`, 2 or more where there is one
  double sharpness = 1e-4;  ///< the sides of a border are at most this share of the range apart
  int jobs = 0;             ///< threads; 0: as many as there are processors
};

/// How closely the command line and the page look: at one number, or at a map of two with fewer values a row.
RegionOrder order_of(VariedNumber across, std::optional<VariedNumber> along);

/// One of the routes that are the fastest somewhere. The passages that it leads through tell it from others: which
/// turns it takes there may change within its regions.
struct RegionRoute {
  WallSet walls;     ///< that it passes
  WallSet passages;  ///< and the open ones straight behind its end, where a run may stop
  int cells = 0;     ///< that it enters
  DriveRoute route;  ///< as it is driven by `model`
  DriveModel model;  ///< one of those by which it is the fastest
};

/// How the best of the other routes compares.
struct RunnerUp {
  int route = 0;
  double loss = 0.0;  ///< by how much it is slower, as a share of the winner's time
};

/// Values between which every one that was planned has the same fastest route.
struct RouteRegion {
  static constexpr int refused = -1;

  double from = 0.0, to = 0.0;  ///< the first and the last value that was planned
  int route = refused;          ///< its place in RouteRegions::routes
  std::string refusal;          ///< why there is none: the robot is refused, or has no route
  DriveTime time_from = no_time, time_to = no_time;
  std::optional<RunnerUp> runner_up;  ///< in the middle of the region, among all routes found
};

/// At one value of the second number; from the first value of the varied one to the last.
struct RegionRow {
  double at = 0.0;
  std::vector<RouteRegion> regions;
};

struct RouteRegions {
  std::vector<RegionRoute> routes;  ///< in the order in which they win, row by row
  std::vector<RegionRow> rows;
  /// Where one number is varied alone: the values at which all of the routes were timed, evenly spaced, and the times,
  /// route by route; no_time where one cannot be driven.
  std::vector<double> values;
  std::vector<std::vector<DriveTime>> times;
  int plans = 0;  ///< that the regions took
};

/// The regions of a maze up to 32×32.
RouteRegions find_regions(const Maze& maze, const RobotFamily& family, const RegionOrder& order);

/// "A" to "Z", then "A1" and so on.
std::string letter_of(int route);

/// The regions as a table for people, a row of them or many.
std::string table_of(const RouteRegions& regions, const RegionOrder& order, const std::string& maze,
                     const std::string& robot);
std::string json_of(const RouteRegions& regions, const RegionOrder& order, const std::string& maze,
                    const std::string& robot);

}  // namespace labmouse
