#include "labmouse/contest/lap_route.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "labmouse/mouse/pose.hpp"

namespace labmouse {
namespace {

constexpr int corners = 4;

DriveTime sum(DriveTime a, DriveTime b) { return std::min<DriveTime>(no_time, a + b); }

/// The cells of the ring from side to side: side i begins in the corner cell of side i - 1, and side 0 in the start.
struct Side {
  Cell begin;
  Heading heading = Heading::north;
  int cells = 0;  ///< moves from corner to corner
};

std::array<Side, corners> sides_of(Size size, Pose start) {
  std::array<Side, corners> sides;
  for (Side& side : sides) {
    const bool upright = start.heading == Heading::north || start.heading == Heading::south;
    side = {start.cell, start.heading, (upright ? size.height : size.width) - 1};
    start = {neighbour(side.begin, side.heading, side.cells), right_of(side.heading)};
  }
  return sides;
}

Pose start_of(const Maze& maze) { return {maze.start(), maze.start_heading()}; }

/// The turns at the corners of a lap, as places in DriveTables::turns: at the ends of the sides, the last one at the
/// start.
struct Lap {
  DriveTime time = no_time;  ///< from the turn before it to the end of its last turn
  std::array<std::size_t, corners> turns{};
};

/// Where a route can end on the first side.
struct Finish {
  int units = 0;  ///< half cells after the last turn
  DriveTime time = no_time;
};

class LapPlanner {
 public:
  LapPlanner(Size size, Pose start, const DriveTables& tables) : tables_(tables), sides_(sides_of(size, start)) {
    for (std::size_t i = 0; i < tables.turns.size(); ++i)
      if (tables.turns[i].turn == Turn::f90 || tables.turns[i].turn == Turn::s90) choices_.push_back(i);
  }

  /// The fastest lap that ends with the turn with which it began, and can follow a lap from rest.
  Lap flying() const {
    Lap best;
    for (const std::size_t turn : choices_) {
      const Lap lap = fastest(turn, only(turn));
      if (lap.time < best.time && first(turn).time < no_time) best = lap;
    }
    return best;
  }

  DriveRoute route(int laps) const {
    const Lap flying = this->flying();
    if (laps == 1 || flying.time >= no_time) return written({fastest(std::nullopt, to_finish())});
    const std::size_t turn = flying.turns.back();
    std::vector<Lap> all = {first(turn)};
    const Lap last = fastest(turn, to_finish(turn));
    DriveTime time = sum(all.front().time, last.time);
    for (int lap = 2; lap < laps && (time = sum(time, flying.time)) < no_time; ++lap) all.push_back(flying);
    all.push_back(last);
    return written(all);
  }

 private:
  /// Half cells between the corner and the end of a turn.
  int reach(std::size_t turn) const { return tables_.turns[turn].turn == Turn::f90 ? 2 : 1; }

  /// The time along a side, from a turn or from rest at the start, to the next turn.
  DriveTime along(std::size_t side, std::optional<std::size_t> from, std::size_t to) const {
    const int units = units_of(side, from, to);
    if (units < 0) return no_time;
    const std::size_t lane = tables_.turns[to].from;
    return from ? tables_.along.at(units, tables_.turns[*from].to, lane) : tables_.start_to(units, lane);
  }
  int units_of(std::size_t side, std::optional<std::size_t> from, std::size_t to) const {
    return 2 * sides_[side].cells - (from ? reach(*from) : 0) - reach(to);
  }

  /// The fastest turns at the four corners after a turn, or from rest. `rest`: by turn, as in choices_, the time after
  /// the last one; it counts for the choice only.
  Lap fastest(std::optional<std::size_t> before, const std::vector<DriveTime>& rest) const {
    std::vector<Lap> laps;
    for (const std::size_t turn : choices_) laps.push_back(extended({0, {}}, 0, before, turn));
    for (std::size_t corner = 1; corner < corners; ++corner) {
      std::vector<Lap> next;
      for (const std::size_t turn : choices_) {
        Lap best;
        for (const Lap& lap : laps) {
          const Lap longer = extended(lap, corner, lap.turns[corner - 1], turn);
          if (longer.time < best.time) best = longer;
        }
        next.push_back(best);
      }
      laps = std::move(next);
    }
    Lap best;
    DriveTime least = no_time;
    for (std::size_t i = 0; i < laps.size(); ++i)
      if (const DriveTime time = sum(laps[i].time, rest[i]); time < least) {
        best = laps[i];
        least = time;
      }
    return best;
  }

  /// The fastest lap from rest that ends with that turn.
  Lap first(std::size_t turn) const { return fastest(std::nullopt, only(turn)); }

  Lap extended(Lap lap, std::size_t corner, std::optional<std::size_t> from, std::size_t turn) const {
    lap.time = sum(sum(lap.time, along(corner, from, turn)), tables_.turns[turn].time);
    lap.turns[corner] = turn;
    return lap;
  }

  /// The first cell after the last turn in whose middle the route can end.
  Finish finish(std::size_t turn) const {
    for (int cell = 1; cell <= sides_[0].cells; ++cell) {
      const int units = 2 * cell - reach(turn);
      const DriveTime time = tables_.finish_from(units, tables_.turns[turn].to, sides_[0].cells - cell);
      if (time < no_time) return {units, time};
    }
    return {};
  }
  /// No time after that last turn; others are not allowed.
  std::vector<DriveTime> only(std::size_t turn) const {
    std::vector<DriveTime> rest;
    for (const std::size_t choice : choices_) rest.push_back(choice == turn ? 0 : no_time);
    return rest;
  }
  /// The time after a last turn: after that one alone, if the route can end after it.
  std::vector<DriveTime> to_finish(std::optional<std::size_t> wanted = std::nullopt) const {
    const bool alone = wanted && finish(*wanted).time < no_time;
    std::vector<DriveTime> rest;
    for (const std::size_t choice : choices_)
      rest.push_back(alone && choice != *wanted ? no_time : finish(choice).time);
    return rest;
  }

  DriveRoute written(const std::vector<Lap>& laps) const {
    DriveRoute route;
    for (const Lap& lap : laps)
      if (lap.time >= no_time) return route;
    route.time = 0;
    DriveNode here = {sides_[0].begin, sides_[0].heading, Place::centre};
    std::optional<std::size_t> before;
    for (const Lap& lap : laps)
      for (std::size_t corner = 0; corner < corners; ++corner) {
        const std::size_t turn = lap.turns[corner];
        const Side &side = sides_[corner], &next = sides_[(corner + 1) % corners];
        const DriveNode begin = short_of(next.begin, side.heading, turn), end = behind(next.begin, next.heading, turn);
        add(route, {DriveSegment::Kind::straight, here, begin, 0, along(corner, before, turn),
                    units_of(corner, before, turn), 0, false});
        add(route, {DriveSegment::Kind::turn, begin, end, 0, tables_.turns[turn].time, 0,
                    static_cast<std::uint16_t>(turn), false});
        here = end;
        before = turn;
      }
    const Finish end = finish(*before);
    const Cell cell = neighbour(sides_[0].begin, here.heading, (end.units + reach(*before)) / 2);
    add(route,
        {DriveSegment::Kind::straight, here, {cell, here.heading, Place::centre}, 0, end.time, end.units, 0, false});
    return route;
  }

  /// The nodes where a turn at a corner begins and ends.
  DriveNode short_of(Cell corner, Heading heading, std::size_t turn) const {
    return {neighbour(corner, heading, -1), heading, reach(turn) == 2 ? Place::centre : Place::edge};
  }
  DriveNode behind(Cell corner, Heading heading, std::size_t turn) const {
    if (reach(turn) == 2) return {neighbour(corner, heading), heading, Place::centre};
    return {corner, heading, Place::edge};
  }

  /// Adds a segment, whose `end` is its time. A straight of no length and time is left out.
  static void add(DriveRoute& route, DriveSegment segment) {
    if (segment.kind == DriveSegment::Kind::straight && segment.units == 0 && segment.end == 0) return;
    segment.begin = route.time;
    route.time = segment.end = segment.begin + segment.end;
    route.segments.push_back(segment);
  }

  const DriveTables& tables_;
  std::array<Side, corners> sides_;
  std::vector<std::size_t> choices_;  ///< all turns of 90 degrees, as places in DriveTables::turns
};

bool can_be_driven(const Maze& maze) { return starts_on_ring(maze) && !closed_on_ring(maze); }

}  // namespace

bool starts_on_ring(const Maze& maze) {
  const Size size = maze.size();
  if (size.width < 2 || size.height < 2) return false;
  // Clockwise: the ring's side lies ahead, and the border behind and to the left.
  const auto inside = [&](Heading heading) { return size.contains(neighbour(maze.start(), heading)); };
  const Heading heading = maze.start_heading();
  return inside(heading) && inside(right_of(heading)) && !inside(left_of(heading)) && !inside(opposite(heading));
}

WallSet ring_of(Size size) {
  WallSet walls;
  for (const Side& side : sides_of(size, {}))
    for (int cell = 0; cell < side.cells; ++cell)
      walls.insert(wall_at(neighbour(side.begin, side.heading, cell), side.heading));
  return walls;
}

std::optional<Wall> closed_on_ring(const Maze& maze) {
  for (const Side& side : sides_of(maze.size(), start_of(maze)))
    for (int i = 0; i < side.cells; ++i)
      if (const Cell cell = neighbour(side.begin, side.heading, i); !maze.is_open(cell, side.heading))
        return wall_at(cell, side.heading);
  return std::nullopt;
}

DriveRoute lap_route(const Maze& maze, const DriveModel& model, int laps) {
  if (!can_be_driven(maze)) return {};
  return LapPlanner(maze.size(), start_of(maze), model.tables).route(laps);
}

DriveTime flying_lap(const Maze& maze, const DriveModel& model) {
  if (!can_be_driven(maze)) return no_time;
  return LapPlanner(maze.size(), start_of(maze), model.tables).flying().time;
}

}  // namespace labmouse
