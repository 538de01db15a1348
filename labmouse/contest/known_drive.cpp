#include "labmouse/contest/known_drive.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "labmouse/body/body.hpp"
#include "labmouse/controller/controller.hpp"
#include "labmouse/functions/whole.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "labmouse/mouse/drive/search_field.hpp"

namespace labmouse {
namespace {

/// Search moves to the nearest goal, edge by edge; empty if there is no way.
std::vector<Action> search_moves(const Maze& maze, const SearchDrive& search) {
  SearchField field(maze.size(), search);
  field.fill(maze.open_walls(), CellSet(), maze.goals());
  std::vector<Action> moves;
  SearchPlace place = {{maze.start(), maze.start_heading()}, true};
  while (!maze.is_goal(place.pose.cell)) {
    Action move = field.step(place);
    if (move.kind != Action::Kind::step) return {};
    move.movement = std::min(move.movement, 1);
    moves.push_back(move);
    place = after_search(place, move);
  }
  return moves;
}

/// All walls of a maze.
Knowledge knowledge_of(const Maze& maze) {
  Knowledge known(maze.size());
  WallSet::all(maze.size()).for_each([&](Wall wall) { known.learn(wall, maze.open_walls().contains(wall)); });
  return known;
}

double angle_between(const Direction& a, const Direction& b) {
  // Small angles: the sine is the angle.
  return a.sine * b.cosine - a.cosine * b.sine;
}

void add_errors(WayErrors& errors, const Position& at, const Direction& way, const Target& target) {
  const Position off = at - target.position;
  errors.along += square(off.x * target.ahead.cosine + off.y * target.ahead.sine);
  errors.aside += square(off.y * target.ahead.cosine - off.x * target.ahead.sine);
  errors.direction += square(angle_between(way, target.ahead));
}

void count(WallReadings& readings, Evidence evidence, bool stands) {
  ++readings.all;
  if ((evidence > 0) != stands) ++readings.wrong;
}

class KnownDriver {
 public:
  KnownDriver(const Maze& maze, const DriveModel& model, const PhysicalConditions& conditions, std::uint64_t seed,
              std::vector<LoggedTick>* log)
      : maze_(maze),
        cell_(model.tables.cell),
        known_(knowledge_of(maze)),
        body_(maze, cell_, *model.robot.hardware, conditions.errors, seed),
        controller_(model, *model.robot.hardware, maze.size(), gains_for(*model.robot.hardware, cell_),
                    conditions.controller),
        log_(log) {
    body_.put(maze.start(), maze.start_heading());
    if (log_ != nullptr) stand();
    controller_.put({maze.start(), maze.start_heading()});
  }

  /// The controller gets no wall map here, as in a search.
  KnownDrive search(const std::vector<Action>& moves) {
    for (std::size_t next = 0;; ++next) {
      if (!drive_on()) return drive_;
      drive_.cells = static_cast<int>(next);
      if (next > 0) read();
      if (next == moves.size()) return drive_;
      controller_.search(moves[next]);
    }
  }

  KnownDrive run(const DriveRoute& route) {
    controller_.know(&known_);
    if (!drive_on()) return drive_;
    body_.set_fan(true);
    controller_.run(route);
    drive_on();
    return drive_;
  }

 private:
  /// Ticks until the controller has arrived; false after a crash.
  bool drive_on() {
    for (;;) {
      if (!pending_) {
        duties_ = controller_.tick(body_.sense());
        pending_ = true;
      }
      if (controller_.arrived()) return true;
      pending_ = false;
      if (log_ != nullptr) log_->push_back({body_.sense(), duties_, body_.motion()});
      const Touch touch = body_.step(duties_);
      note();
      if (touch == Touch::graze) ++drive_.grazes;
      if (touch != Touch::crash) continue;
      drive_.crashed = true;
      return false;
    }
  }

  void stand() {
    constexpr int ticks = 500;
    for (int tick = 0; tick < ticks; ++tick) {
      log_->push_back({body_.sense(), {}, body_.motion()});
      body_.step({});
    }
  }

  void note() {
    const Target& target = controller_.target();
    const BodyMotion& motion = body_.motion();
    ++drive_.ticks;
    add_errors(drive_.truth, motion.position, turned_by(motion.ahead, motion.slip), target);
    add_errors(drive_.estimate, controller_.estimate().position, controller_.estimate().way(), target);
    const Position off = motion.position - target.position;
    drive_.most_aside = std::max(drive_.most_aside, std::abs(off.y * target.ahead.cosine - off.x * target.ahead.sine));
  }

  void read() {
    const Pose pose = controller_.place().pose;
    const WallEvidence evidence = controller_.evidence();
    count(drive_.side, evidence.left, !maze_.is_open(pose.cell, left_of(pose.heading)));
    count(drive_.side, evidence.right, !maze_.is_open(pose.cell, right_of(pose.heading)));
    count(drive_.front, evidence.ahead, !maze_.is_open(pose.cell, pose.heading));
  }

  const Maze& maze_;
  double cell_;
  Knowledge known_;
  Body body_;
  Controller controller_;
  std::vector<LoggedTick>* log_;
  KnownDrive drive_;
  Drive duties_;
  bool pending_ = false;
};

}  // namespace

WayErrors& WayErrors::operator+=(const WayErrors& other) {
  along += other.along;
  aside += other.aside;
  direction += other.direction;
  return *this;
}

WallReadings& WallReadings::operator+=(const WallReadings& other) {
  all += other.all;
  wrong += other.wrong;
  return *this;
}

std::optional<KnownDrive> drive_known_way(const Maze& maze, const DriveModel& model,
                                          const PhysicalConditions& conditions, KnownWay way, std::uint64_t seed,
                                          std::vector<LoggedTick>* log) {
  if (way == KnownWay::search) {
    const std::vector<Action> moves = search_moves(maze, model.search);
    if (moves.empty()) return std::nullopt;
    return KnownDriver(maze, model, conditions, seed, log).search(moves);
  }
  FastestRoutes routes(maze.size(), route_tables_of(model));
  const Pose start = {maze.start(), maze.start_heading()};
  routes.fill_for(start, maze.open_walls(), maze.goals());
  DriveRoute route;
  routes.route_from(start, route);
  if (route.time == no_time || route.segments.empty()) return std::nullopt;
  return KnownDriver(maze, model, conditions, seed, log).run(route);
}

int moves_of_known_way(const Maze& maze, const DriveModel& model) {
  return static_cast<int>(search_moves(maze, model.search).size());
}

}  // namespace labmouse
