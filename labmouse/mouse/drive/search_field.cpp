#include "labmouse/mouse/drive/search_field.hpp"

#include <algorithm>
#include <cassert>
#include <new>

namespace labmouse {
namespace {

/// Of two times; what comes to no_time or more is none.
DriveTime sum(std::int64_t a, std::int64_t b) { return static_cast<DriveTime>(std::min<std::int64_t>(no_time, a + b)); }

/// The price of a closed wall.
constexpr std::uint8_t closed = 0xff;

}  // namespace

std::size_t SearchField::bytes_for(Size size) {
  const auto edges = static_cast<std::size_t>(4 * size.area());
  return edges * (sizeof(DriveTime) + 2 * sizeof(std::uint16_t)) + edges / 2;
}

SearchField::SearchField(Size size, const SearchDrive& drive)
    : SearchField(size, drive, std::span(new std::byte[bytes_for(size)], bytes_for(size))) {
  own_.reset(reinterpret_cast<std::byte*>(times_));
}

SearchField::SearchField(Size size, const SearchDrive& drive, std::span<std::byte> memory)
    : size_(size), drive_(drive) {
  assert(drive.cell > 0 && drive.turn > 0 && drive.back > 0);
  assert(memory.size() >= bytes_for(size) && 4 * size.area() < EdgeHeap::nowhere);
  const auto edges = static_cast<std::size_t>(4 * size.area());
  times_ = new (memory.data()) DriveTime[edges];
  auto* const numbers = new (memory.data() + edges * sizeof(DriveTime)) std::uint16_t[2 * edges];
  heap_ = EdgeHeap(numbers, numbers + edges, times_);
  prices_ = new (numbers + 2 * edges) std::uint8_t[edges / 2];
  std::fill(times_, times_ + edges, no_time);
  std::fill(prices_, prices_ + edges / 2, closed);
}

template <class Price>
void SearchField::set_prices(DriveTime unit, Price price) {
  unit_ = unit;
  for (int index = 0; index < size_.area(); ++index)
    for (const Heading heading : {Heading::north, Heading::east}) {
      const Wall wall = wall_at(size_.cell_at(index), heading);
      prices_[wall_of(wall)] = on_border(wall, size_) ? closed : static_cast<std::uint8_t>(price(wall));
    }
}

DriveTime SearchField::toll(Cell cell, Heading heading) const {
  const Wall wall = wall_at(cell, heading);
  if (!size_.contains(wall.cell)) return no_time;
  const std::uint8_t price = prices_[wall_of(wall)];
  return price == closed ? no_time : sum(0, std::int64_t{price} * unit_);
}

void SearchField::fill(const WallSet& passages, const CellSet& targets) {
  set_prices(0, [&](Wall wall) { return passages.contains(wall) ? 0 : closed; });
  search(targets);
}

void SearchField::fill(const WallPrices& prices, DriveTime unit, const CellSet& targets) {
  set_prices(unit, [&](Wall wall) { return prices.passable(wall) ? prices.of(wall) : closed; });
  search(targets);
}

void SearchField::search(const CellSet& targets) {
  targets_ = targets;
  const auto edges = static_cast<std::size_t>(4 * size_.area());
  std::fill(times_, times_ + edges, no_time);
  heap_.clear(edges);
  targets.for_each([&](Cell cell) {
    for (const Heading heading : all_headings) reach(edge_of(cell, heading), 0);
  });
  while (!heap_.empty()) {
    const std::size_t edge = heap_.take();
    expand({size_.cell_at(static_cast<int>(edge / 4)), all_headings[edge % 4]}, times_[edge]);
  }
}

void SearchField::reach(std::size_t edge, DriveTime time) {
  if (time >= times_[edge]) return;
  times_[edge] = time;
  heap_.reach(edge);
}

/// Lowers the times of the edges from which one move leads to this one.
void SearchField::expand(Pose pose, DriveTime time) {
  const Cell before = neighbour(pose.cell, pose.heading, -1);
  if (!size_.contains(before)) return;
  const DriveTime rest = sum(time, toll(before, pose.heading));
  if (rest == no_time) return;
  reach(edge_of(before, pose.heading), sum(rest, drive_.cell));
  reach(edge_of(before, left_of(pose.heading)), sum(rest, drive_.turn));
  reach(edge_of(before, right_of(pose.heading)), sum(rest, drive_.turn));
  reach(edge_of(before, opposite(pose.heading)), sum(rest, drive_.back));
}

DriveTime SearchField::through(const SearchPlace& place, const Move& move) const {
  const Heading direction = turned(place.pose.heading, move.quarters);
  const DriveTime extra = toll(place.pose.cell, direction);
  if (extra == no_time) return no_time;
  return sum(sum(extra, move.time), times_[edge_of(neighbour(place.pose.cell, direction), direction)]);
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
