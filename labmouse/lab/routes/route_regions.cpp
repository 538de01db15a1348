#include "labmouse/lab/routes/route_regions.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "labmouse/lab/routes/one_plan.hpp"
#include "labmouse/lab/system/parallel.hpp"
#include "labmouse/mouse/drive/fastest.hpp"

namespace labmouse {
namespace {

DriveRoute fastest_by(const Maze& maze, const WallSet& passages, const DriveModel& model) {
  return fastest_route(maze, passages, std::make_shared<const RouteTables>(model.tables, maze.size()));
}

/// The passages of a route, and the open ones straight ahead of its end.
WallSet passages_of(const DriveRoute& route, const Maze& maze) {
  WallSet passages = walls_of(route);
  if (route.segments.empty()) return passages;
  const DriveNode& end = route.segments.back().to;
  Cell cell = end.cell;
  for (const Heading heading = end.heading; maze.is_open(cell, heading); cell = neighbour(cell, heading))
    passages.insert(wall_at(cell, heading));
  return passages;
}

/// One plan: the values of the varied numbers, and the route of that robot.
struct Plan {
  double across = 0.0;
  std::size_t row = 0;
  DriveModel model;
  DriveRoute route;
  WallSet walls;
  std::string refusal;
  int winner = RouteRegion::refused;

  bool refused() const { return !refusal.empty(); }
};

class Search {
 public:
  Search(const Maze& maze, const RobotFamily& family, const RegionOrder& order)
      : maze_(maze), family_(family), order_(order), rows_(order.along ? static_cast<std::size_t>(order.rows) : 1) {}

  RouteRegions find() {
    std::vector<Plan> plans;
    for (std::size_t row = 0; row < rows_; ++row)
      for (int i = 0; i < order_.samples; ++i) plans.push_back(planned_later(across_at(i), row));
    while (!plans.empty()) {
      make(plans);
      plans = between();
    }
    name_routes();
    return regions();
  }

 private:
  static Plan planned_later(double across, std::size_t row) {
    Plan plan;
    plan.across = across;
    plan.row = row;
    return plan;
  }

  static double step(double from, double to, int i, int steps) {
    return i == steps ? to : from + (to - from) * i / steps;
  }
  double across_at(int i) const { return step(order_.across.from, order_.across.to, i, order_.samples - 1); }
  double along_at(std::size_t row) const {
    return order_.along ? step(order_.along->from, order_.along->to, static_cast<int>(row), order_.rows - 1) : 0.0;
  }

  RobotResult robot_at(double across, std::size_t row) const {
    std::vector<RobotNumber> numbers = {{order_.across.key, across}};
    if (order_.along) numbers.push_back({order_.along->key, along_at(row)});
    return family_.with(numbers);
  }

  void plan(Plan& plan) const {
    RobotResult robot = robot_at(plan.across, plan.row);
    if (!robot.robot) {
      plan.refusal = robot.problems.empty() ? "the robot is refused" : robot.problems.front().reason;
      return;
    }
    plan.model = std::move(robot.model);
    plan.route = fastest_by(maze_, maze_.open_walls(), plan.model);
    plan.walls = walls_of(plan.route);
    if (plan.route.time >= no_time) plan.refusal = "no route leads from the start to a goal";
  }

  /// Computes these plans and merges them into the sorted list.
  void make(std::vector<Plan>& plans) {
    for_each_parallel(plans.size(), order_.jobs, [&](std::size_t i) { plan(plans[i]); });
    std::move(plans.begin(), plans.end(), std::back_inserter(plans_));
    std::sort(plans_.begin(), plans_.end(),
              [](const Plan& a, const Plan& b) { return a.row != b.row ? a.row < b.row : a.across < b.across; });
  }

  static bool agree(const Plan& a, const Plan& b) {
    return a.refused() ? b.refused() : !b.refused() && a.walls == b.walls;
  }

  /// The midpoints between neighbours with different routes that are not yet close enough.
  std::vector<Plan> between() const {
    const double close = order_.sharpness * (order_.across.to - order_.across.from);
    std::vector<Plan> middles;
    for (std::size_t i = 1; i < plans_.size(); ++i) {
      const Plan &left = plans_[i - 1], &right = plans_[i];
      if (left.row != right.row || agree(left, right) || right.across - left.across <= close) continue;
      const double middle = left.across + (right.across - left.across) / 2.0;
      if (middle > left.across && middle < right.across) middles.push_back(planned_later(middle, left.row));
    }
    return middles;
  }

  void name_routes() {
    for (Plan& plan : plans_) {
      if (plan.refused()) continue;
      const auto known = std::find_if(routes_.begin(), routes_.end(),
                                      [&](const RegionRoute& route) { return route.walls == plan.walls; });
      plan.winner = static_cast<int>(known - routes_.begin());
      if (known == routes_.end())
        routes_.push_back(
            {plan.walls, passages_of(plan.route, maze_), plan.walls.count(), plan.route, std::move(plan.model)});
      else
        known->passages |= passages_of(plan.route, maze_);
    }
  }

  RouteRegions regions() {
    RouteRegions found;
    found.plans = static_cast<int>(plans_.size());
    for (std::size_t row = 0; row < rows_; ++row) found.rows.push_back({along_at(row), {}});
    for (const Plan& plan : plans_) {
      std::vector<RouteRegion>& row = found.rows[plan.row].regions;
      if (row.empty() || row.back().route != plan.winner)
        row.push_back({plan.across, plan.across, plan.winner, plan.refusal, plan.route.time, plan.route.time, {}});
      row.back().to = plan.across;
      row.back().time_to = plan.route.time;
    }
    add_runners_up(found);
    if (!order_.along) add_times(found);
    found.routes = std::move(routes_);
    return found;
  }

  void add_runners_up(RouteRegions& found) const {
    if (routes_.size() < 2) return;
    struct Place {
      std::size_t row;
      RouteRegion* region;
    };
    std::vector<Place> places;
    for (std::size_t row = 0; row < found.rows.size(); ++row)
      for (RouteRegion& region : found.rows[row].regions)
        if (region.route != RouteRegion::refused) places.push_back({row, &region});
    for_each_parallel(places.size(), order_.jobs,
                      [&](std::size_t i) { find_runner_up(*places[i].region, places[i].row); });
  }

  void add_times(RouteRegions& found) const {
    for (int i = 0; i < order_.samples; ++i) found.values.push_back(across_at(i));
    found.times.assign(routes_.size(), std::vector<DriveTime>(found.values.size(), no_time));
    for_each_parallel(found.values.size(), order_.jobs, [&](std::size_t i) {
      const RobotResult robot = robot_at(found.values[i], 0);
      if (!robot.robot) return;
      for (std::size_t route = 0; route < routes_.size(); ++route)
        found.times[route][i] = fastest_by(maze_, routes_[route].passages, robot.model).time;
    });
  }

  void find_runner_up(RouteRegion& region, std::size_t row) const {
    const RobotResult robot = robot_at(region.from + (region.to - region.from) / 2.0, row);
    if (!robot.robot) return;
    const auto time_of = [&](int route) {
      return fastest_by(maze_, routes_[static_cast<std::size_t>(route)].passages, robot.model).time;
    };
    const DriveTime winner = time_of(region.route);
    DriveTime least = no_time;
    for (int other = 0; other < static_cast<int>(routes_.size()); ++other) {
      if (other == region.route) continue;
      const DriveTime time = time_of(other);
      if (time >= least) continue;
      least = time;
      region.runner_up = {other, static_cast<double>(time) / winner - 1.0};
    }
  }

  const Maze& maze_;
  const RobotFamily& family_;
  const RegionOrder& order_;
  std::size_t rows_;
  std::vector<Plan> plans_;  ///< sorted by row, then by value
  std::vector<RegionRoute> routes_;
};

}  // namespace

RegionOrder order_of(VariedNumber across, std::optional<VariedNumber> along) {
  RegionOrder order;
  order.across = std::move(across);
  order.along = std::move(along);
  if (!order.along) return order;
  order.rows = 33;
  order.samples = 17;
  order.sharpness = 1e-3;
  return order;
}

RouteRegions find_regions(const Maze& maze, const RobotFamily& family, const RegionOrder& order) {
  return Search(maze, family, order).find();
}

}  // namespace labmouse
