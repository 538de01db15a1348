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

bool overlap(const CellSet& cells, const CellSet& others) {
  CellSet both = cells;
  both &= others;
  return !both.empty();
}

/// Calls visit(cell, now) for the cells that are in one of the sets only: whether in the one of now.
template <class Visit>
void for_each_difference(const CellSet& now, const CellSet& before, Visit visit) {
  CellSet added = now, taken = before;
  added -= before;
  taken -= now;
  added.for_each([&](Cell cell) { visit(cell, true); });
  taken.for_each([&](Cell cell) { visit(cell, false); });
}

}  // namespace

std::size_t SearchField::due_bytes(Size size) { return static_cast<std::size_t>(4 * size.area()) * sizeof(DriveTime); }
std::size_t SearchField::bytes_for(Size size) {
  const auto edges = static_cast<std::size_t>(4 * size.area());
  return edges * (sizeof(DriveTime) + 2 * sizeof(std::uint16_t)) + edges / 2;
}

SearchField::SearchField(Size size, const SearchDrive& drive)
    : SearchField(size, drive, new std::byte[due_bytes(size) + bytes_for(size)], due_bytes(size)) {
  own_.reset(reinterpret_cast<std::byte*>(due_));
  passages_ = std::make_unique<WallSet>();
}

SearchField::SearchField(Size size, const SearchDrive& drive, std::span<std::byte> memory)
    : SearchField(size, drive, memory.data(), 0) {
  assert(memory.size() >= bytes_for(size));
}

SearchField::SearchField(Size size, const SearchDrive& drive, std::byte* memory, std::size_t due_bytes)
    : size_(size), drive_(drive) {
  assert(drive.cell > 0 && drive.turn > 0 && drive.back > 0);
  assert(4 * size.area() < EdgeHeap::nowhere);
  const auto edges = static_cast<std::size_t>(4 * size.area());
  due_ = new (memory) DriveTime[edges];
  times_ = new (memory + due_bytes) DriveTime[edges];
  auto* const numbers = new (memory + due_bytes + edges * sizeof(DriveTime)) std::uint16_t[2 * edges];
  heap_ = EdgeHeap(numbers, numbers + edges, due_);
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
  if (repairable_ && overlap(targets, targets_)) {
    repair(passages, known, targets);
  } else {
    set_prices({drive_}, [&](Wall wall) { return passages.contains(wall) ? 0 : closed; });
    begin(known, targets);
  }
  repairable_ = own_ != nullptr;
  if (repairable_) *passages_ = passages;
  search(place);
}

void SearchField::fill(const WallPrices& prices, const SearchTolls& tolls, const CellSet& known, const CellSet& targets,
                       const SearchPlace* place) {
  repairable_ = false;
  set_prices(tolls, [&](Wall wall) { return prices.of(wall) < tolls.closed ? prices.of(wall) : closed; });
  begin(known, targets);
  search(place);
}

void SearchField::begin(const CellSet& known, const CellSet& targets) {
  known_ = known;
  targets_ = targets;
  const auto edges = static_cast<std::size_t>(4 * size_.area());
  std::fill(times_, times_ + edges, no_time);
  heap_.clear(edges);
  targets.for_each([&](Cell cell) {
    for (const Heading heading : all_headings) reach(edge_of(cell, heading), 0);
  });
}

/// Goes on from the edges that wait, as far as a place needs it.
void SearchField::search(const SearchPlace* place) {
  // Once the time from the place is a sum of final ones, edges that are further off make none that is less.
  DriveTime enough = place != nullptr ? from(*place) : no_time;
  while (!heap_.empty() && due_[heap_.first()] <= enough) {
    const std::size_t edge = heap_.take();
    take(edge);
    if (place != nullptr && leads_to(*place, pose_of(edge))) enough = from(*place);
  }
}

/// Lets an edge wait for a time, if that is less than what it has or waits for.
void SearchField::reach(std::size_t edge, DriveTime time) {
  if (time >= times_[edge] || (heap_.contains(edge) && time >= due_[edge])) return;
  due_[edge] = time;
  heap_.reach(edge);
}

/// It is the turn of an edge.
void SearchField::take(std::size_t edge) {
  if (own_ == nullptr || due_[edge] < times_[edge]) {
    times_[edge] = due_[edge];
    expand(edge);
    return;
  }
  const DriveTime lost = times_[edge];
  if (best_of(edge) == lost) return;
  times_[edge] = no_time;
  repair(edge);
  // Those whose best move led here, or does as far as they know.
  const Pose pose = pose_of(edge);
  if (!passes(neighbour(pose.cell, pose.heading, -1), pose.heading)) return;
  for_each_before(pose, [&](std::size_t from, DriveTime move) {
    const DriveTime time = sum(lost, move);
    if (time == times_[from] || (heap_.contains(from) && time == due_[from])) repair(from);
  });
}

/// Lowers the times of the edges from which one move leads to this one.
void SearchField::expand(std::size_t edge) {
  const Pose pose = pose_of(edge);
  const Cell before = neighbour(pose.cell, pose.heading, -1);
  if (!size_.contains(before)) return;
  const DriveTime extra = toll(before, pose.heading);
  if (extra == no_time) return;
  const DriveTime time = times_[edge];
  for_each_before(pose, [&](std::size_t from, DriveTime move) { reach(from, sum(time, some_time(move + extra))); });
}

/// Calls visit(edge, time) for all edges from which one move leads to this one, where its own wall is open.
template <class Visit>
void SearchField::for_each_before(const Pose& pose, Visit visit) const {
  const Cell before = neighbour(pose.cell, pose.heading, -1);
  visit(edge_of(before, pose.heading), tolls_.drive.cell);
  visit(edge_of(before, left_of(pose.heading)), tolls_.drive.turn);
  visit(edge_of(before, right_of(pose.heading)), tolls_.drive.turn);
  visit(edge_of(before, opposite(pose.heading)), tolls_.drive.back);
  if (drive_.dashes()) for_each_dash_before(pose, visit);
}

/// The same of dashes that end at this edge, which alone may cost or save something: known cells have no unseen walls.
template <class Visit>
void SearchField::for_each_dash_before(const Pose& pose, Visit visit) const {
  Cell before = neighbour(pose.cell, pose.heading, -1);
  for (int cells = 2; known_.contains(before); ++cells) {
    before = neighbour(before, pose.heading, -1);
    if (toll(before, pose.heading) == no_time) return;
    visit(edge_of(before, pose.heading), drive_.dash(cells));
  }
}

/// Lets all edges wait whose best move is another by these walls and cells.
void SearchField::repair(const WallSet& passages, const CellSet& known, const CellSet& targets) {
  repair_walls(passages);
  for_each_difference(known, known_, [&](Cell cell, bool now) {
    now ? known_.insert(cell) : known_.erase(cell);
    if (drive_.dashes()) repair_dashes(cell);
  });
  for_each_difference(targets, targets_, [&](Cell cell, bool now) {
    now ? targets_.insert(cell) : targets_.erase(cell);
    for (const Heading heading : all_headings) repair(edge_of(cell, heading));
  });
}

void SearchField::repair_walls(const WallSet& passages) {
  const auto change = [&](const WallSet& walls, std::uint8_t price) {
    walls.for_each([&](Wall wall) {
      prices_[wall_of(wall)] = price;
      repair_before({neighbour(wall.cell, wall.side), wall.side});
      repair_before({wall.cell, opposite(wall.side)});
    });
  };
  WallSet opened = passages, shut = *passages_;
  opened -= *passages_;
  shut -= passages;
  change(opened, 0);
  change(shut, closed);
}

/// The dashes through a cell may have become possible, or not any more.
void SearchField::repair_dashes(Cell cell) {
  for (const Heading heading : all_headings) {
    const Cell before = neighbour(cell, heading, -1);
    if (!size_.contains(before) || toll(before, heading) == no_time) continue;
    repair(edge_of(before, heading));
    for_each_dash_before({cell, heading}, [&](std::size_t from, DriveTime) { repair(from); });
  }
}

/// What leads to an edge, or could if its wall were open, may have become later or earlier.
void SearchField::repair_before(const Pose& pose) {
  if (size_.contains(neighbour(pose.cell, pose.heading, -1)))
    for_each_before(pose, [&](std::size_t from, DriveTime) { repair(from); });
}

/// Lets an edge wait if its time is not that of its best move.
void SearchField::repair(std::size_t edge) {
  const DriveTime time = best_of(edge);
  heap_.remove(edge);
  if (time == times_[edge]) return;
  due_[edge] = std::min(time, times_[edge]);
  heap_.reach(edge);
}

/// The same as from() of an edge, where no wall costs or saves anything.
DriveTime SearchField::best_of(std::size_t edge) const {
  const Pose pose = pose_of(edge);
  if (targets_.contains(pose.cell)) return 0;
  DriveTime best = no_time;
  const auto by = [&](Heading heading, DriveTime move) {
    if (passes(pose.cell, heading))
      best = std::min(best, times_[edge_of(neighbour(pose.cell, heading), heading)] + move);
  };
  by(pose.heading, drive_.cell);
  by(left_of(pose.heading), drive_.turn);
  by(right_of(pose.heading), drive_.turn);
  by(opposite(pose.heading), drive_.back);
  if (!drive_.dashes() || !passes(pose.cell, pose.heading)) return best;
  Cell next = neighbour(pose.cell, pose.heading);
  for (int cells = 2; known_.contains(next) && passes(next, pose.heading); ++cells) {
    next = neighbour(next, pose.heading);
    best = std::min(best, times_[edge_of(next, pose.heading)] + drive_.dash(cells));
  }
  return best;
}

bool SearchField::passes(Cell cell, Heading heading) const {
  const Wall wall = wall_at(cell, heading);
  return size_.contains(wall.cell) && prices_[wall_of(wall)] != closed;
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
