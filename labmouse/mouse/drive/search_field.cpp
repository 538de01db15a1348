#include "labmouse/mouse/drive/search_field.hpp"

#include <algorithm>
#include <cassert>

namespace labmouse {
namespace {

/// Of two times; what comes to no_time or more is none.
DriveTime sum(std::int64_t a, std::int64_t b) { return static_cast<DriveTime>(std::min<std::int64_t>(no_time, a + b)); }

}  // namespace

SearchField::SearchField(Size size, const SearchDrive& drive) : size_(size), drive_(drive) {
  assert(drive.cell > 0 && drive.turn > 0 && drive.back > 0);
  const auto edges = static_cast<std::size_t>(4 * size.area());
  tolls_.assign(edges, no_time);
  times_.assign(edges, no_time);
  // Each edge is reached from at most four others.
  heap_.reserve(4 * edges);
}

template <class Toll>
void SearchField::set_tolls(Toll toll) {
  for (int index = 0; index < size_.area(); ++index)
    for (const Heading heading : all_headings) {
      const Wall wall = wall_at(size_.cell_at(index), heading);
      tolls_[edge_of(size_.cell_at(index), heading)] = on_border(wall, size_) ? no_time : toll(wall);
    }
}

void SearchField::fill(const WallSet& passages, const CellSet& targets) {
  set_tolls([&](Wall wall) { return passages.contains(wall) ? 0 : no_time; });
  search(targets);
}

void SearchField::fill(const WallPrices& prices, DriveTime unit, const CellSet& targets) {
  set_tolls([&](Wall wall) { return prices.passable(wall) ? sum(0, std::int64_t{prices.of(wall)} * unit) : no_time; });
  search(targets);
}

void SearchField::search(const CellSet& targets) {
  targets_ = targets;
  std::fill(times_.begin(), times_.end(), no_time);
  heap_.clear();
  targets.for_each([&](Cell cell) {
    for (const Heading heading : all_headings) reach(edge_of(cell, heading), 0);
  });
  const auto later = [](const Waiting& a, const Waiting& b) { return a.time > b.time; };
  while (!heap_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end(), later);
    const Waiting next = heap_.back();
    heap_.pop_back();
    const auto edge = static_cast<std::size_t>(next.edge);
    if (next.time == times_[edge]) expand({size_.cell_at(next.edge / 4), all_headings[edge % 4]}, next.time);
  }
}

void SearchField::reach(std::size_t edge, DriveTime time) {
  if (time >= times_[edge]) return;
  times_[edge] = time;
  heap_.push_back({time, static_cast<std::int32_t>(edge)});
  std::push_heap(heap_.begin(), heap_.end(), [](const Waiting& a, const Waiting& b) { return a.time > b.time; });
}

/// Lowers the times of the edges from which one move leads to this one.
void SearchField::expand(Pose pose, DriveTime time) {
  const Cell before = neighbour(pose.cell, pose.heading, -1);
  if (!size_.contains(before)) return;
  const DriveTime rest = sum(time, tolls_[edge_of(before, pose.heading)]);
  if (rest == no_time) return;
  reach(edge_of(before, pose.heading), sum(rest, drive_.cell));
  reach(edge_of(before, left_of(pose.heading)), sum(rest, drive_.turn));
  reach(edge_of(before, right_of(pose.heading)), sum(rest, drive_.turn));
  reach(edge_of(before, opposite(pose.heading)), sum(rest, drive_.back));
}

DriveTime SearchField::through(const SearchPlace& place, const Move& move) const {
  const Heading direction = turned(place.pose.heading, move.quarters);
  const DriveTime toll = tolls_[edge_of(place.pose.cell, direction)];
  if (toll == no_time) return no_time;
  return sum(sum(toll, move.time), times_[edge_of(neighbour(place.pose.cell, direction), direction)]);
}

template <class Visit>
void SearchField::for_each_move(const SearchPlace& place, Visit visit) const {
  for (const int quarters : {0, -1, 1, 2}) {
    const Heading direction = turned(place.pose.heading, quarters);
    visit(Move{quarters, search_time(drive_, place, search_step(place.pose.heading, direction, 1))});
  }
}

DriveTime SearchField::from(const SearchPlace& place) const {
  if (targets_.contains(place.pose.cell)) return 0;
  DriveTime least = no_time;
  for_each_move(place, [&](const Move& move) { least = std::min(least, through(place, move)); });
  return least;
}

Action SearchField::step(const SearchPlace& place) const {
  if (targets_.contains(place.pose.cell)) return Action::step(0, 0);
  const DriveTime least = from(place);
  Action best = Action::forfeit(ForfeitReason::no_way);
  if (least == no_time) return best;
  for_each_move(place, [&](const Move& move) {
    if (best.kind == Action::Kind::forfeit && through(place, move) == least)
      best = search_step(place.pose.heading, turned(place.pose.heading, move.quarters), 1);
  });
  return best;
}

}  // namespace labmouse
