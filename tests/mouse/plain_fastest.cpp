#include "tests/mouse/plain_fastest.hpp"

#include <algorithm>
#include <array>

namespace labmouse::test {
namespace {

/// One step in each of the eight directions.
constexpr std::array<HalfPoint, 8> steps = {{{0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}}};

HalfPoint step(int direction) { return steps[static_cast<unsigned>(direction) & 7U]; }
HalfPoint moved(HalfPoint point, int direction, int count) {
  return {point.x + count * step(direction).x, point.y + count * step(direction).y};
}
bool is_centre(HalfPoint point) { return point.x % 2 != 0 && point.y % 2 != 0; }

/// A turn to the left as points ahead and to the left of its first: the last, and those that must be open.
struct Outline {
  Turn turn;
  bool from_centre;
  HalfPoint end;
  std::array<HalfPoint, 4> open;  ///< unused ones repeat the first
};

constexpr std::array<Outline, 5> outlines = {{
    {Turn::f45, true, {2, 1}, {{{1, 0}, {2, 1}, {3, 2}, {1, 0}}}},
    {Turn::f90, true, {2, 2}, {{{1, 0}, {2, 1}, {1, 0}, {1, 0}}}},
    {Turn::f135, true, {1, 2}, {{{1, 0}, {2, 1}, {1, 2}, {0, 3}}}},
    {Turn::f180, true, {0, 2}, {{{1, 0}, {2, 1}, {1, 2}, {1, 0}}}},
    {Turn::s90, false, {1, 1}, {{{0, 0}, {1, 1}, {0, 0}, {0, 0}}}},
}};

}  // namespace

PlainFastest::PlainFastest(Size size, const DriveTables& tables, const WallSet& passages, const CellSet& goals)
    : size_(size),
      tables_(tables),
      passages_(passages),
      goals_(goals),
      lanes_(std::max(tables.along.count(), tables.diagonal.count())) {
  const auto spots = static_cast<std::size_t>((2 * size.width + 1) * (2 * size.height + 1) * 8);
  ending_.resize(spots);
  times_.assign(spots * 2 * lanes_, no_time);
  find_places();
  begin_at_goals();
  settle();
}

bool PlainFastest::passable(HalfPoint point) const {
  if (point.x <= 0 || point.y <= 0 || point.x >= 2 * size_.width || point.y >= 2 * size_.height) return false;
  const Cell cell = {(point.x - 1) / 2, (point.y - 1) / 2};
  if (is_centre(point)) return true;
  if (point.x % 2 != 0) return passages_.contains({cell, Heading::north});
  return point.y % 2 != 0 && passages_.contains({cell, Heading::east});
}

std::size_t PlainFastest::label(Spot spot, bool turning, std::size_t lane) const {
  const auto point = static_cast<std::size_t>(spot.point.y * (2 * size_.width + 1) + spot.point.x);
  return ((point * 8 + static_cast<std::size_t>(spot.direction)) * 2 + (turning ? 1 : 0)) * lanes_ + lane;
}

void PlainFastest::find_places() {
  for (int y = 1; y < 2 * size_.height; ++y)
    for (int x = 1; x < 2 * size_.width; ++x)
      for (int direction = 0; direction < 8; ++direction)
        for (const int side : {-1, 1}) {
          const Spot from = {{x, y}, direction};
          if (direction % 2 != 0)
            add_diagonal_turn(from, side);
          else
            for (const Outline& outline : outlines) add_turn(outline.turn, from, side);
        }
}

/// Adds a turn to one side (-1 left, 1 right) if its walls are open, and where it leads onto a diagonal the one back.
void PlainFastest::add_turn(Turn turn, Spot from, int side) {
  const auto& outline =
      *std::find_if(outlines.begin(), outlines.end(), [&](const Outline& o) { return o.turn == turn; });
  const bool centre = is_centre(from.point);
  if (centre != outline.from_centre || !passable(from.point)) return;
  // An edge node lies on a wall that its direction crosses.
  if (!centre && passable(from.point) && !is_centre(moved(from.point, from.direction, 1))) return;
  const auto place = [&](HalfPoint relative) {
    return moved(moved(from.point, from.direction, relative.x), from.direction + 8 + 2 * side, relative.y);
  };
  for (const HalfPoint& open : outline.open)
    if (!passable(place(open))) return;
  const Spot to = {place(outline.end), (from.direction + 8 + side * eighths(turn)) % 8};
  const auto add = [&](const DrivenPlace& found) {
    ending_[label(found.to, false, 0) / (2 * lanes_)].push_back(found);
  };
  add({from, to, turn});
  if (!ends_diagonal(turn)) return;
  add({{to.point, (to.direction + 4) % 8}, {from.point, (from.direction + 4) % 8}, reversed(turn)});
}

/// V90: round a post, from the middle of a wall over that of a second to that of a third, coming from one before and
/// going on towards one behind.
void PlainFastest::add_diagonal_turn(Spot from, int side) {
  if (is_centre(from.point) || !passable(from.point) || !passable(moved(from.point, from.direction, -1))) return;
  const HalfPoint middle = moved(from.point, from.direction, 1);
  const int after = (from.direction + 8 + 2 * side) % 8;
  const HalfPoint end = moved(middle, after, 1);
  const HalfPoint inside = {(from.point.x + end.x) / 2, (from.point.y + end.y) / 2};
  if (is_centre(inside)) return;  // that would come back into the cell that it was about to leave
  if (!passable(middle) || !passable(end) || !passable(moved(end, after, 1))) return;
  const DrivenPlace found = {from, {end, after}, Turn::v90};
  ending_[label(found.to, false, 0) / (2 * lanes_)].push_back(found);
}

void PlainFastest::reach(std::size_t label, DriveTime time) {
  if (time >= times_[label]) return;
  times_[label] = time;
  queue_.emplace_back(time, label);
  std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
}

/// The open cells straight behind a goal.
int PlainFastest::room_behind(HalfPoint goal, int direction) const {
  int room = 0;
  while (passable(moved(goal, direction, 2 * room + 1))) ++room;
  return room;
}

/// Straights into the middle of a goal.
void PlainFastest::begin_at_goals() {
  goals_.for_each([&](Cell cell) {
    for (int direction = 0; direction < 8; direction += 2) {
      HalfPoint point = half_point({cell, Heading::north, Place::centre});
      const int room = room_behind(point, direction);
      for (int units = 0; passable(point); ++units, point = moved(point, direction + 4, 1))
        for (std::size_t lane = 0; lane < tables_.along.count(); ++lane)
          reach(label({point, direction}, false, lane), tables_.finish_from(units, lane, room));
    }
  });
}

void PlainFastest::settle() {
  while (!queue_.empty()) {
    std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
    const auto [time, label] = queue_.back();
    queue_.pop_back();
    if (time > times_[label]) continue;
    const std::size_t lane = label % lanes_;
    const bool turning = label / lanes_ % 2 != 0;
    const auto rest = static_cast<int>(label / (2 * lanes_));
    const int point = rest / 8;
    const Spot spot = {{point % (2 * size_.width + 1), point / (2 * size_.width + 1)}, rest % 8};
    turning ? before_turn(spot, lane, time) : before_straight(spot, lane, time);
  }
}

/// A turn begins here in that lane: straights of all lengths lead up to it.
void PlainFastest::before_turn(Spot spot, std::size_t lane, DriveTime time) {
  const StraightTimes& table = straights(spot.direction);
  HalfPoint point = spot.point;
  for (int units = 0; units <= StraightTimes::longest && passable(point); ++units) {
    for (std::size_t before = 0; before < table.count(); ++before)
      if (const DriveTime straight = table.at(units, before, lane); straight < no_time)
        reach(label({point, spot.direction}, false, before), time + straight);
    point = moved(point, spot.direction + 4, 1);
  }
}

/// A straight begins here behind a turn that ended in that lane.
void PlainFastest::before_straight(Spot spot, std::size_t lane, DriveTime time) {
  for (const DrivenPlace& place : ending_[label(spot, false, 0) / (2 * lanes_)])
    for (const DrivenTurn& turn : tables_.turns)
      if (turn.turn == place.turn && turn.to == lane) reach(label(place.from, true, turn.from), time + turn.time);
}

DriveTime PlainFastest::rolling(const DriveNode& node, std::size_t lane) const {
  const HalfPoint point = half_point(node);
  if (!passable(point)) return no_time;
  return times_[label({point, eighths(node)}, false, lane)];
}

bool PlainFastest::turn_ends(const DriveNode& node, std::size_t lane) const {
  const auto& places = ending_[label({half_point(node), eighths(node)}, false, 0) / (2 * lanes_)];
  return std::any_of(places.begin(), places.end(), [&](const DrivenPlace& place) {
    return std::any_of(tables_.turns.begin(), tables_.turns.end(),
                       [&](const DrivenTurn& turn) { return turn.turn == place.turn && turn.to == lane; });
  });
}

DriveTime PlainFastest::time_from(Pose start) const {
  if (goals_.contains(start.cell)) return 0;
  DriveTime best = no_time;
  const int direction = eighths(start.heading);
  HalfPoint point = half_point({start.cell, start.heading, Place::centre});
  for (int units = 0; units <= StraightTimes::longest && passable(point); ++units) {
    if (is_centre(point) && goals_.contains({(point.x - 1) / 2, (point.y - 1) / 2}))
      best = std::min(best, tables_.whole_way(units, room_behind(point, direction)));
    for (std::size_t lane = 0; lane < tables_.along.count(); ++lane) {
      const DriveTime rest = times_[label({point, direction}, true, lane)];
      if (rest < no_time && tables_.start_to(units, lane) < no_time)
        best = std::min(best, tables_.start_to(units, lane) + rest);
    }
    point = moved(point, direction, 1);
  }
  return best;
}

}  // namespace labmouse::test
