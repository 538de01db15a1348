#include "labmouse/mouse/drive/search_field.hpp"

#include <algorithm>
#include <cassert>
#include <new>

namespace labmouse {
namespace {

/// Of two times; what comes to no_time or more is none.
DriveTime sum(std::int64_t a, std::int64_t b) { return static_cast<DriveTime>(std::min<std::int64_t>(no_time, a + b)); }

/// Every move takes some time, whatever it saves.
DriveTime some_time(DriveTime time) { return std::max<DriveTime>(time, 1); }

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
void SearchField::set_prices(const SearchTolls& tolls, Price price) {
  tolls_ = tolls;
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
  if (price == closed) return no_time;
  const DriveTime saved =
      tolls_.savings.empty() ? 0 : tolls_.savings[static_cast<std::size_t>(size_.index(neighbour(cell, heading)))];
  return price == 0 ? -saved : sum(tolls_.base - saved, std::int64_t{price} * tolls_.unit);
}

void SearchField::fill(const WallSet& passages, const CellSet& known, const CellSet& targets,
                       const SearchPlace* place) {
  set_prices({drive_}, [&](Wall wall) { return passages.contains(wall) ? 0 : closed; });
  search(known, targets, place);
}

void SearchField::fill(const WallPrices& prices, const SearchTolls& tolls, const CellSet& known, const CellSet& targets,
                       const SearchPlace* place) {
  set_prices(tolls, [&](Wall wall) { return prices.of(wall) < tolls.closed ? prices.of(wall) : closed; });
  search(known, targets, place);
}

void SearchField::search(const CellSet& known, const CellSet& targets, const SearchPlace* place) {
  known_ = known;
  targets_ = targets;
  const auto edges = static_cast<std::size_t>(4 * size_.area());
  std::fill(times_, times_ + edges, no_time);
  heap_.clear(edges);
  targets.for_each([&](Cell cell) {
    for (const Heading heading : all_headings) reach(edge_of(cell, heading), 0);
  });
  DriveTime enough = no_time;
  while (!heap_.empty()) {
    const std::size_t edge = heap_.take();
    if (times_[edge] > enough) return;
    const Pose pose = {size_.cell_at(static_cast<int>(edge / 4)), all_headings[edge % 4]};
    expand(pose, times_[edge]);
    // Once the time from the place is a sum of final ones, edges that are further off make none that is less.
    if (place != nullptr && leads_to(*place, pose)) enough = from(*place);
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
  const DriveTime extra = toll(before, pose.heading);
  if (extra == no_time) return;
  const auto by = [&](Heading heading, DriveTime move) {
    reach(edge_of(before, heading), sum(time, some_time(move + extra)));
  };
  by(pose.heading, tolls_.drive.cell);
  by(left_of(pose.heading), tolls_.drive.turn);
  by(right_of(pose.heading), tolls_.drive.turn);
  by(opposite(pose.heading), tolls_.drive.back);
  if (drive_.dashes()) expand_dashes(pose, time, extra);
}

/// The same for dashes that end at this edge, which alone may cost or save something: known cells have no unseen walls.
void SearchField::expand_dashes(Pose pose, DriveTime time, DriveTime extra) {
  Cell before = neighbour(pose.cell, pose.heading, -1);
  for (int cells = 2; known_.contains(before); ++cells) {
    before = neighbour(before, pose.heading, -1);
    if (toll(before, pose.heading) == no_time) return;
    reach(edge_of(before, pose.heading), sum(time, some_time(drive_.dash(cells) + extra)));
  }
}

DriveTime SearchField::through(const SearchPlace& place, const Move& move) const {
  const Heading direction = turned(place.pose.heading, move.quarters);
  const DriveTime extra = toll(neighbour(place.pose.cell, direction, move.cells - 1), direction);
  if (extra == no_time) return no_time;
  return sum(some_time(extra + move.time),
             times_[edge_of(neighbour(place.pose.cell, direction, move.cells), direction)]);
}

template <class Visit>
void SearchField::for_each_move(const SearchPlace& place, Visit visit) const {
  for (const int quarters : {0, -1, 1, 2}) {
    const Heading direction = turned(place.pose.heading, quarters);
    visit(Move{quarters, 1, search_time(tolls_.drive, place, search_step(place.pose.heading, direction, 1))});
    if (quarters == 0 && !place.at_rest && drive_.dashes()) for_each_dash(place.pose, visit);
  }
}

template <class Visit>
void SearchField::for_each_dash(const Pose& edge, Visit visit) const {
  if (toll(edge.cell, edge.heading) == no_time) return;
  Cell next = neighbour(edge.cell, edge.heading);
  for (int cells = 2; known_.contains(next) && toll(next, edge.heading) != no_time; ++cells) {
    visit(Move{0, cells, drive_.dash(cells)});
    next = neighbour(next, edge.heading);
  }
}

/// Whether a move from the place may lead to that edge.
bool SearchField::leads_to(const SearchPlace& place, const Pose& edge) const {
  const Cell from = place.pose.cell, to = edge.cell;
  if (to == neighbour(from, edge.heading)) return true;
  return drive_.dashes() && (to.x == from.x || to.y == from.y);
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
      best = search_step(place.pose.heading, turned(place.pose.heading, move.quarters), move.cells);
  });
  return best;
}

}  // namespace labmouse
