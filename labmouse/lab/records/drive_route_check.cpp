#include "labmouse/lab/records/drive_route_check.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "labmouse/lab/records/drive_notation.hpp"
#include "labmouse/mouse/drive/fastest.hpp"

namespace labmouse {
namespace {

/// One step in each of the eight directions, in half cells.
constexpr std::array<HalfPoint, 8> steps = {{{0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}}};

HalfPoint moved(HalfPoint point, int direction, int count) {
  const HalfPoint step = steps[static_cast<unsigned>(direction) % 8];
  return {point.x + count * step.x, point.y + count * step.y};
}

class RouteCheck {
 public:
  RouteCheck(const DriveRoute& route, Pose start, Size size, const WallSet& open, const CellSet& goals,
             const DriveModel& model)
      : route_(route),
        size_(size),
        goals_(goals),
        model_(model),
        start_{start.cell, start.heading, Place::centre},
        room_(room_behind(route, open)) {}

  std::string disagreement() {
    for (index_ = 0; index_ < route_.segments.size(); ++index_) {
      const std::string wrong = wrong_place().empty() ? wrong_time() : wrong_place();
      if (!wrong.empty())
        return fmt::format("segment {} ({}): {}", index_ + 1, notation_of(here(), model_.tables), wrong);
    }
    const DriveNode& end = route_.segments.empty() ? start_ : route_.segments.back().to;
    if (end.place != Place::centre || !goals_.contains(end.cell))
      return "the route does not end in the centre of a goal";
    if (last_is_turn() && time_of_nothing(route_.segments.size()) != 0)
      return "the route ends with a turn that leads further";
    return "";
  }

 private:
  /// The number of open walls in a line ahead of the end of the route, up to max_drive_side.
  static int room_behind(const DriveRoute& route, const WallSet& open) {
    if (route.segments.empty()) return 0;
    const DriveNode& end = route.segments.back().to;
    int room = 0;
    while (room < max_drive_side && open.contains(wall_at(neighbour(end.cell, end.heading, room), end.heading))) ++room;
    return room;
  }

  const DriveSegment& here() const { return route_.segments[index_]; }
  bool last_is_turn() const { return !route_.segments.empty() && is_turn(route_.segments.back()); }
  static bool is_turn(const DriveSegment& segment) { return segment.kind == DriveSegment::Kind::turn; }

  bool inside(HalfPoint point) const {
    return point.x > 0 && point.y > 0 && point.x < 2 * size_.width && point.y < 2 * size_.height;
  }

  /// Where a turn leads: the end of its shape, to the nearest half cell.
  HalfPoint end_of_turn() const {
    const PathPoint& end = model_.shapes[here().turn].end;
    const double half = model_.tables.cell / 2.0, eighth = 0.78539816339744830962;
    const double angle = eighths(here().from) * eighth, aside = here().left ? end.aside : -end.aside;
    const double x = std::sin(angle) * end.ahead - std::cos(angle) * aside;
    const double y = std::cos(angle) * end.ahead + std::sin(angle) * aside;
    const HalfPoint from = half_point(here().from);
    return {from.x + static_cast<int>(std::lround(x / half)), from.y + static_cast<int>(std::lround(y / half))};
  }

  Turn turn() const { return model_.tables.turns[here().turn].turn; }

  /// The least number of half cells ahead of the turn's first node that must be inside the maze.
  int reach_ahead() const { return begins_diagonal(turn()) || turn() == Turn::s90 ? 1 : 2; }

  /// Whether a turn of this kind may begin at the segment's first node. A V90 (diagonal to diagonal) has one possible
  /// side: to the other side it would come back into the same cell.
  bool may_begin() const {
    const DriveSegment& segment = here();
    if (begins_diagonal(turn()) != segment.from.diagonal()) return false;
    if (turn() == Turn::v90) return segment.left == (segment.from.place == Place::left);
    return segment.from.diagonal() || segment.from.place == (turn() == Turn::s90 ? Place::edge : Place::centre);
  }

  std::string wrong_place() const {
    const DriveSegment& segment = here();
    const DriveNode& due = index_ == 0 ? start_ : route_.segments[index_ - 1].to;
    if (segment.from != due) return "it does not begin where the previous segment ends";
    if (is_turn(segment) && !may_begin()) return "that turn cannot begin there";
    const HalfPoint from = half_point(segment.from), to = half_point(segment.to);
    const int before = eighths(segment.from), after = eighths(segment.to);
    const bool turns = is_turn(segment);
    const int angle = turns ? (segment.left ? -1 : 1) * eighths(turn()) : 0;
    const HalfPoint end = turns ? end_of_turn() : moved(from, before, segment.units);
    if (to != end || after != (before + 8 + angle) % 8) return "it does not lead to its recorded end";
    // A turn passes points ahead of its ends; a U-turn reaches furthest.
    for (const HalfPoint point :
         {from, to, moved(from, before, turns ? reach_ahead() : 0), moved(to, after, turns ? -1 : 0)})
      if (!inside(point)) return "it leaves the maze";
    return "";
  }

  const DriveSegment* turn_at(std::size_t index) const {
    return index < route_.segments.size() && is_turn(route_.segments[index]) ? &route_.segments[index] : nullptr;
  }

  /// The time of a straight of that length between two turns, each of which may be missing.
  DriveTime straight_time(int units, const DriveSegment* before, const DriveSegment* behind) const {
    const DriveTables& tables = model_.tables;
    const auto lane = [&](const DriveSegment* turn, std::uint8_t DrivenTurn::*end) -> std::size_t {
      return tables.turns[turn->turn].*end;
    };
    const bool diagonal = before != nullptr && ends_diagonal(tables.turns[before->turn].turn);
    if (diagonal != (behind != nullptr && begins_diagonal(tables.turns[behind->turn].turn))) return no_time;
    if (before == nullptr && behind == nullptr) return tables.whole_way(units, room_);
    if (before == nullptr) return tables.start_to(units, lane(behind, &DrivenTurn::from));
    if (behind == nullptr) return tables.finish_from(units, lane(before, &DrivenTurn::to), room_);
    return (diagonal ? tables.diagonal : tables.along)
        .at(units, lane(before, &DrivenTurn::to), lane(behind, &DrivenTurn::from));
  }

  /// The time of a straight of no length between two turns, which a route leaves out.
  DriveTime time_of_nothing(std::size_t index) const {
    return straight_time(0, index > 0 ? turn_at(index - 1) : nullptr, turn_at(index));
  }

  std::string wrong_time() const {
    const DriveSegment& segment = here();
    const DriveTime begin = index_ == 0 ? 0 : route_.segments[index_ - 1].end;
    if (segment.begin != begin) return "it does not begin when the previous segment ends";
    const DriveSegment* before = index_ > 0 ? turn_at(index_ - 1) : nullptr;
    if (!is_turn(segment) && index_ > 0 && before == nullptr) return "it follows another straight";
    if (is_turn(segment) && (index_ == 0 || before != nullptr) && time_of_nothing(index_) != 0)
      return "the robot cannot begin it there";
    const DriveTime time = is_turn(segment) ? model_.tables.turns[segment.turn].time
                                            : straight_time(segment.units, before, turn_at(index_ + 1));
    if (time >= no_time) return "the robot cannot change its speed that fast";
    if (segment.end - segment.begin == time) return "";
    return fmt::format("recorded as {:.6f} s, but it takes {:.6f} s", (segment.end - segment.begin) / 1e6, time / 1e6);
  }

  const DriveRoute& route_;
  Size size_;
  const CellSet& goals_;
  const DriveModel& model_;
  DriveNode start_;
  int room_;
  std::size_t index_ = 0;
};

}  // namespace

std::string check_route(const DriveRoute& route, Pose start, Size size, const WallSet& open, const CellSet& goals,
                        const DriveModel& model) {
  if (auto wrong = RouteCheck(route, start, size, open, goals, model).disagreement(); !wrong.empty()) return wrong;
  WallSet closed = walls_of(route);
  closed -= open;
  if (closed.empty()) return "";
  std::string first;
  closed.for_each([&](Wall wall) {
    if (first.empty()) first = fmt::format("the {} side of ({},{})", name_of(wall.side), wall.cell.x, wall.cell.y);
  });
  return fmt::format("the route passes {}, which is not known to be open", first);
}

}  // namespace labmouse
