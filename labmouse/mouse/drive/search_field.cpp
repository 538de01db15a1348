#include "labmouse/mouse/drive/search_field.hpp"

#include <algorithm>
#include <cassert>
#include <new>

#include "labmouse/mouse/drive/edges.hpp"

namespace labmouse {
namespace {

/// The sum of two times, at most no_time.
DriveTime sum(std::int64_t a, std::int64_t b) { return static_cast<DriveTime>(std::min<std::int64_t>(no_time, a + b)); }

/// Every move takes some time, whatever it saves.
DriveTime some_time(DriveTime time) { return std::max<DriveTime>(time, 1); }

bool same_moves(const SearchDrive& a, const SearchDrive& b) {
  return a.cell == b.cell && a.turn == b.turn && a.back == b.back;
}

bool overlap(const CellSet& cells, const CellSet& others) {
  CellSet both = cells;
  both &= others;
  return !both.empty();
}

/// Calls visit(cell, whether it is in `now`) for the cells that are in only one of the sets.
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
  return edges * (sizeof(DriveTime) + 2 * sizeof(std::uint16_t) + sizeof(std::uint8_t));
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
    : size_(size), drive_(drive), ahead_(edges_ahead(size)) {
  assert(drive.cell > 0 && drive.turn > 0 && drive.back > 0);
  assert(4 * size.area() < EdgeBuckets::first_of_bucket);
  const auto edges = static_cast<std::size_t>(4 * size.area());
  due_ = new (memory) DriveTime[edges];
  times_ = new (memory + due_bytes) DriveTime[edges];
  auto* const numbers = new (memory + due_bytes + edges * sizeof(DriveTime)) std::uint16_t[2 * edges];
  queue_ = EdgeBuckets(numbers, numbers + edges, due_);
  prices_ = new (numbers + 2 * edges) std::uint8_t[edges];
  std::fill(times_, times_ + edges, no_time);
  std::fill(prices_, prices_ + edges, closed);
}

template <class Price>
void SearchField::set_prices(const SearchTolls& tolls, Price price) {
  tolls_ = tolls;
  std::fill(prices_, prices_ + 4 * size_.area(), closed);
  for (Cell cell{0, 0}; cell.y < size_.height; ++cell.y)
    for (cell.x = 0; cell.x < size_.width; ++cell.x) {
      if (const Wall wall{cell, Heading::north}; cell.y + 1 < size_.height) set_price(wall, price(wall));
      if (const Wall wall{cell, Heading::east}; cell.x + 1 < size_.width) set_price(wall, price(wall));
    }
}

void SearchField::set_price(Wall wall, std::uint8_t price) {
  const std::size_t side = edge_of(wall.cell, wall.side);
  prices_[side] = prices_[behind(ahead_of(side))] = price;
}

bool SearchField::is_shut_behind(std::size_t edge) const { return prices_[behind(edge)] == closed; }

/// The cost of entering a cell by an edge besides the time of the move, or no_time.
DriveTime SearchField::toll(std::size_t edge) const {
  const std::uint8_t price = prices_[behind(edge)];
  if (price == closed) return no_time;
  const DriveTime saved = tolls_.savings.empty() ? 0 : tolls_.savings[edge / 4];
  return price == 0 ? -saved : sum(tolls_.base - saved, std::int64_t{price} * tolls_.unit);
}

void SearchField::fill(const SearchDrive& moves, const WallSet& passages, const CellSet& known, const CellSet& targets,
                       const SearchPlace* place) {
  if (repairable_ && same_moves(moves, tolls_.drive) && overlap(targets, targets_)) {
    repair(passages, known, targets);
  } else {
    set_prices({moves}, [&](Wall wall) { return passages.contains(wall) ? std::uint8_t{0} : closed; });
    begin(known, targets);
  }
  // Repairs need the exact order of edges of which one move leads to the other.
  repairable_ = own_ != nullptr && bucket_width() <= shortest_move();
  if (repairable_) *passages_ = passages;
  search(place);
}

void SearchField::fill(const WallPrices& prices, const SearchTolls& tolls, const CellSet& known, const CellSet& targets,
                       const SearchPlace* place) {
  repairable_ = false;
  set_prices(tolls, [&](Wall wall) {
    const int price = prices.of(wall);
    return price < tolls.closed ? static_cast<std::uint8_t>(price) : closed;
  });
  begin(known, targets);
  search(place);
}

DriveTime SearchField::shortest_move() const {
  const SearchDrive& moves = tolls_.drive;
  const DriveTime least = std::min({moves.cell, moves.turn, moves.back});
  constexpr int shortest_dash = 2;
  return drive_.dashes() ? std::min(least, drive_.dash(shortest_dash)) : least;
}

/// The shortest move, unless a strategy counts it as next to nothing.
DriveTime SearchField::bucket_width() const {
  constexpr int buckets_a_cell = 16;
  return std::max<DriveTime>({shortest_move(), drive_.cell / buckets_a_cell, 1});
}

void SearchField::begin(const CellSet& known, const CellSet& targets) {
  known_ = known;
  targets_ = targets;
  const auto edges = static_cast<std::size_t>(4 * size_.area());
  std::fill(times_, times_ + edges, no_time);
  queue_.clear(edges, bucket_width());
  targets.for_each([&](Cell cell) {
    for (const Heading heading : all_headings) reach(edge_of(cell, heading), 0);
  });
}

/// Takes edges from the queue, as far as a place needs them.
void SearchField::search(const SearchPlace* place) {
  // Edges that are due after the time from the place cannot lower it.
  DriveTime enough = place != nullptr ? from(*place) : no_time;
  while (queue_.find(enough)) {
    const std::size_t edge = queue_.take();
    take(edge);
    if (place != nullptr && leads_to(*place, edge)) enough = from(*place);
  }
}

/// Queues an edge for a time, if that is less than its own time and than what it is queued for.
void SearchField::reach(std::size_t edge, DriveTime time) {
  if (time >= times_[edge] || (queue_.contains(edge) && time >= due_[edge])) return;
  due_[edge] = time;
  queue_.put(edge);
}

/// Handles an edge that was taken from the queue.
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
  // Repairs the edges whose best move led here, by their own or by their queued time.
  if (is_shut_behind(edge)) return;
  for_each_before(edge, [&](std::size_t from, DriveTime move) {
    const DriveTime time = sum(lost, move);
    if (time == times_[from] || (queue_.contains(from) && time == due_[from])) repair(from);
  });
}

/// Lowers the times of the edges from which one move leads to this one.
void SearchField::expand(std::size_t edge) {
  if (is_shut_behind(edge)) return;
  const DriveTime extra = toll(edge);
  const DriveTime time = times_[edge];
  for_each_before(edge, [&](std::size_t from, DriveTime move) { reach(from, sum(time, some_time(move + extra))); });
}

/// Calls visit(edge, time) for all edges from which one move leads to this one, where its own wall is open.
template <class Visit>
void SearchField::for_each_before(std::size_t edge, Visit visit) const {
  const std::size_t before = edge - ahead_[edge % 4];
  visit(before, tolls_.drive.cell);
  visit(turned_edge(before, 3), tolls_.drive.turn);
  visit(turned_edge(before, 1), tolls_.drive.turn);
  visit(behind(before), tolls_.drive.back);
  if (drive_.dashes()) for_each_dash_before(edge, visit);
}

/// The same for dashes that end at this edge. Only its wall may cost or save something: known cells have no unseen
/// walls.
template <class Visit>
void SearchField::for_each_dash_before(std::size_t edge, Visit visit) const {
  std::size_t before = edge - ahead_[edge % 4];
  for (int cells = 2; known_.contains(pose_of(before).cell) && !is_shut_behind(before); ++cells) {
    before -= ahead_[edge % 4];
    visit(before, drive_.dash(cells));
  }
}

/// Queues all edges whose best move changes with these walls and cells.
void SearchField::repair(const WallSet& passages, const CellSet& known, const CellSet& targets) {
  repair_walls(passages);
  if (drive_.dashes())
    for_each_difference(known, known_, [&](Cell cell, bool now) {
      now ? known_.insert(cell) : known_.erase(cell);
      repair_dashes(cell);
    });
  for_each_difference(targets, targets_, [&](Cell cell, bool now) {
    now ? targets_.insert(cell) : targets_.erase(cell);
    for (const Heading heading : all_headings) repair(edge_of(cell, heading));
  });
}

void SearchField::repair_walls(const WallSet& passages) {
  const auto change = [&](const WallSet& walls, std::uint8_t price) {
    walls.for_each([&](Wall wall) {
      set_price(wall, price);
      const std::size_t side = edge_of(wall.cell, wall.side);
      repair_before(ahead_of(side));
      repair_before(behind(side));
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
    const std::size_t edge = edge_of(cell, heading);
    if (is_shut_behind(edge)) continue;
    repair(edge - ahead_[edge % 4]);
    for_each_dash_before(edge, [&](std::size_t from, DriveTime) { repair(from); });
  }
}

/// Repairs the edges from which one move leads to this one, or would if its wall, an inner one, were open.
void SearchField::repair_before(std::size_t edge) {
  for_each_before(edge, [&](std::size_t from, DriveTime) { repair(from); });
}

/// Queues an edge if its time is not that of its best move.
void SearchField::repair(std::size_t edge) {
  const DriveTime best = best_of(edge), time = std::min(best, times_[edge]);
  if (queue_.contains(edge)) {
    if (best != times_[edge] && time == due_[edge]) return;
    queue_.remove(edge);
  }
  if (best == times_[edge]) return;
  due_[edge] = time;
  queue_.put(edge);
}

/// The same as from() for an edge, if no wall costs or saves anything.
DriveTime SearchField::best_of(std::size_t edge) const {
  const std::size_t cell = edge / 4 * 4, ahead = edge % 4;
  if (targets_.contains(size_.cell_at(static_cast<int>(edge / 4)))) return 0;
  DriveTime best = no_time;
  const auto by = [&](std::size_t heading, DriveTime move) {
    if (prices_[cell + heading] == 0) best = std::min(best, times_[cell + heading + ahead_[heading]] + move);
  };
  by(ahead, tolls_.drive.cell);
  by((ahead + 1) % 4, tolls_.drive.turn);
  by((ahead + 3) % 4, tolls_.drive.turn);
  by((ahead + 2) % 4, tolls_.drive.back);
  if (!drive_.dashes() || prices_[edge] != 0) return best;
  const Pose pose = pose_of(edge);
  Cell next = neighbour(pose.cell, pose.heading);
  std::size_t entered = edge + ahead_[ahead];
  for (int cells = 2; known_.contains(next) && prices_[entered] == 0; ++cells) {
    entered += ahead_[ahead];
    next = neighbour(next, pose.heading);
    best = std::min(best, times_[entered] + drive_.dash(cells));
  }
  return best;
}

DriveTime SearchField::through(const SearchPlace& place, const Move& move) const {
  const Heading direction = turned(place.pose.heading, move.quarters);
  const Cell to = neighbour(place.pose.cell, direction, move.cells);
  if (!size_.contains(to)) return no_time;
  const std::size_t edge = edge_of(to, direction);
  const DriveTime extra = toll(edge);
  return extra == no_time ? no_time : sum(some_time(extra + move.time), times_[edge]);
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
  if (prices_[edge_of(edge.cell, edge.heading)] == closed) return;
  Cell next = neighbour(edge.cell, edge.heading);
  for (int cells = 2; known_.contains(next) && prices_[edge_of(next, edge.heading)] != closed; ++cells) {
    visit(Move{0, cells, drive_.dash(cells)});
    next = neighbour(next, edge.heading);
  }
}

/// Whether a move from the place may lead to that edge.
bool SearchField::leads_to(const SearchPlace& place, std::size_t edge) const {
  if ((edge - ahead_[edge % 4]) / 4 == static_cast<std::size_t>(size_.index(place.pose.cell))) return true;
  if (!drive_.dashes()) return false;
  const Cell from = place.pose.cell, to = pose_of(edge).cell;
  return to.x == from.x || to.y == from.y;
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
  Action best = Action::forfeit(ForfeitReason::no_route);
  if (least == no_time) return best;
  for_each_move(place, [&](const Move& move) {
    if (best.kind == Action::Kind::forfeit && through(place, move) == least)
      best = search_step(place.pose.heading, turned(place.pose.heading, move.quarters), move.cells);
  });
  return best;
}

}  // namespace labmouse
