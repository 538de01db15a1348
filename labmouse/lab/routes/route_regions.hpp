// Varies one or two numbers of a robot file and finds the regions in which one route stays the fastest.
//
// Method: it plans at evenly spaced values. Between neighbours with different routes it bisects until the two sides of
// a border are as close as required; this also finds routes in between. With two numbers it does so at evenly spaced
// values of the second, which gives rows of regions.
// Limit: it misses a region between two neighbouring evenly spaced values with the same route.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/robots/robot_family.hpp"
#include "labmouse/lab/routes/varied_number.hpp"
#include "labmouse/mouse/robot/route.hpp"

namespace labmouse {

/// What to vary, and how finely.
struct RegionOrder {
  VariedNumber across;
  std::optional<VariedNumber> along;
  int samples = 33;         ///< evenly spaced values of `across`, 2 or more
  int rows = 1;             ///< evenly spaced values of `along`, 2 or more where there is one
  double sharpness = 1e-4;  ///< largest distance between the sides of a border, as a share of the range
  int jobs = 0;             ///< threads; 0: as many as there are processors
};

/// The order with the resolution that the command line and the page use. With two numbers, each row has fewer values.
RegionOrder order_of(VariedNumber across, std::optional<VariedNumber> along);

/// A route that is the fastest somewhere. Routes differ by the passages that they cross; the turns may change within a
/// region.
struct RegionRoute {
  WallSet walls;     ///< the passages that it crosses
  WallSet passages;  ///< these, and the open ones straight ahead of its end, where a run may stop
  int cells = 0;     ///< number of cells that it enters
  DriveRoute route;  ///< the route as `model` drives it
  DriveModel model;  ///< a robot for which it is the fastest
};

/// The second fastest route.
struct RunnerUp {
  int route = 0;
  double loss = 0.0;  ///< by how much it is slower, as a share of the winner's time
};

/// A range of values; the route is the fastest at all planned values in it.
struct RouteRegion {
  static constexpr int refused = -1;

  double from = 0.0, to = 0.0;  ///< the first and the last planned value
  int route = refused;          ///< its position in RouteRegions::routes
  std::string refusal;          ///< why there is no route: the robot file has an error, or the maze has no route
  DriveTime time_from = no_time, time_to = no_time;  ///< times of the route at `from` and at `to`
  std::optional<RunnerUp> runner_up;                 ///< at the middle of the region, among all routes found
};

/// The regions at one value of `along`, by rising values of `across`.
struct RegionRow {
  double at = 0.0;
  std::vector<RouteRegion> regions;
};

/// The result of find_regions().
struct RouteRegions {
  std::vector<RegionRoute> routes;  ///< in the order in which they win, row by row
  std::vector<RegionRow> rows;
  /// With one varied number: evenly spaced values, and the time of each route at each of them. A time is no_time where
  /// the route cannot be driven.
  std::vector<double> values;
  std::vector<std::vector<DriveTime>> times;
  int plans = 0;  ///< number of plans made
};

/// The regions of a maze up to 32×32.
RouteRegions find_regions(const Maze& maze, const RobotFamily& family, const RegionOrder& order);

/// The name of a route: "A" to "Z", then "A1" and so on.
std::string letter_of(int route);

/// The regions as a table for people.
std::string table_of(const RouteRegions& regions, const RegionOrder& order, const std::string& maze,
                     const std::string& robot);
std::string json_of(const RouteRegions& regions, const RegionOrder& order, const std::string& maze,
                    const std::string& robot);

}  // namespace labmouse
