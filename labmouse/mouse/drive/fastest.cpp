#include "labmouse/mouse/drive/fastest.hpp"

#include <algorithm>
#include <cassert>
#include <new>

#include "labmouse/mouse/drive/route_passages.hpp"
#include "labmouse/mouse/drive/search.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {
namespace {

/// The node of a point with a direction of driving, as the routes name it.
DriveNode node_at(HalfPoint point, int direction) {
  const auto heading = static_cast<Heading>(direction / 2);
  const Cell centre = {(point.x - 1) / 2, (point.y - 1) / 2};
  if (point.x % 2 != 0 && point.y % 2 != 0) return {centre, heading, Place::centre};
  // Of the two headings of a diagonal the one that crosses the wall it lies on; on the axes that is the heading itself.
  const bool across_north = point.x % 2 != 0;
  const auto crosses = [&](Heading side) { return (side == Heading::north || side == Heading::south) == across_north; };
  const Heading first = crosses(heading) ? heading : right_of(heading);
  const Place place = direction % 2 == 0 ? Place::edge : first == heading ? Place::right : Place::left;
  const Wall wall = {centre, across_north ? Heading::north : Heading::east};
  return {wall.side == first ? wall.cell : neighbour(wall.cell, wall.side), first, place};
}

/// Adds the walls that a segment passes.
void pass(const DriveSegment& segment, WallSet& walls) {
  const auto add = [&](int x, int y) {
    if (x % 2 != 0 && y % 2 != 0) return;  // the middle of a cell
    walls.insert({{(x - 1) / 2, (y - 1) / 2}, x % 2 != 0 ? Heading::north : Heading::east});
  };
  const HalfPoint from = half_point(segment.from), to = half_point(segment.to);
  const HalfPoint before = drive::unit(eighths(segment.from)), after = drive::unit(eighths(segment.to));
  if (segment.kind == DriveSegment::Kind::straight) {
    for (int i = 0; i <= segment.units; ++i) add(from.x + i * before.x, from.y + i * before.y);
    return;
  }
  add(from.x, from.y);
  add(from.x + before.x, from.y + before.y);
  // A half turn goes around the end of a wall, and passes one more place of a wall.
  if (before.x == -after.x && before.y == -after.y)
    add((from.x + to.x) / 2 + 2 * before.x, (from.y + to.y) / 2 + 2 * before.y);
  add(to.x - after.x, to.y - after.y);
  add(to.x, to.y);
}

/// The walls that a route needs, segment by segment.
class NeededWalls {
 public:
  explicit NeededWalls(const DriveTables& tables) : tables_(tables) {}

  void pass(const DriveSegment& segment) {
    labmouse::pass(segment, walls_);
    end_.pass(segment);
  }
  WallSet all() const {
    WallSet walls = walls_;
    for (int cells = end_.room(tables_); cells > 0; --cells)
      walls.insert(wall_at(neighbour(end_.node().cell, end_.node().heading, cells - 1), end_.node().heading));
    return walls;
  }

 private:
  const DriveTables& tables_;
  WallSet walls_;
  RouteEnd end_;
};

}  // namespace

struct RouteTables::Parts {
  Parts(const DriveTables& driven, Size largest)
      : tables(driven), leaps(largest), searches(drive::make_searches(tables, leaps)) {
    for (const DrivenTurn& turn : tables.turns)
      for (auto next = static_cast<std::size_t>(turn.turn) + 1; next < first.size(); ++next) ++first[next];
  }

  DriveTables tables;
  drive::Leaps leaps;
  /// Where the turns of each kind begin in the tables.
  std::array<std::size_t, all_turns.size() + 1> first{};
  std::unique_ptr<drive::SearchMaker> searches;
};

RouteTables::RouteTables(const DriveTables& tables, Size largest) : parts_(std::make_unique<Parts>(tables, largest)) {}
RouteTables::~RouteTables() = default;
std::shared_ptr<const RouteTables> RouteTables::keeping_bounds(const DriveTables& tables) {
  const auto made = std::make_shared<RouteTables>(tables);
  made->parts_->searches->keep_bounds();
  return made;
}

std::shared_ptr<const RouteTables> route_tables_of(const DriveModel& model) {
  return model.route_tables ? model.route_tables : std::make_shared<const RouteTables>(model.tables);
}
void share_route_tables(DriveModel& model) {
  if (!model.route_tables) model.route_tables = RouteTables::keeping_bounds(model.tables);
}

class FastestRoutes::Search {
 public:
  using Parts = RouteTables::Parts;

  /// How much of its memory it takes itself; the search lies behind it.
  static std::size_t own_bytes() { return drive::aligned(sizeof(Search)); }

  Search(Size size, const Parts& parts, std::byte* memory)
      : size_(size), tables_(parts.tables), first_(parts.first), search_(parts.searches->make(size, memory)) {}

  void fill(const WallSet& passages, const CellSet& goals) {
    goals_ = goals;
    search_->fill(passages, goals, drive::Search::everywhere, no_time);
  }
  void fill_for(Pose start, const WallSet& passages, const CellSet& goals, DriveTime limit) {
    goals_ = goals;
    search_->fill(passages_of_routes(size_, passages, start.cell, goals), goals,
                  number({start.cell, start.heading, Place::centre}), limit);
  }
  void aim(Pose start, const WallSet& passages, DriveTime latest) {
    search_->aim(passages, number({start.cell, start.heading, Place::centre}), latest);
  }

  DriveTime time_from(Pose start) const {
    if (goals_.contains(start.cell)) return 0;
    DriveTime best = no_time;
    each_start(start, [&](int, std::size_t, DriveTime first, DriveTime rest) { best = std::min(best, first + rest); });
    return best;
  }

  /// Follows a fastest route that takes this time, and calls visit(segment) for each of its segments.
  template <class Visit>
  void follow(Pose start, DriveTime time, Visit visit) const {
    if (time == 0 || time >= no_time) return;
    Walk<Visit> walk{visit, time, {{start.cell, start.heading, Place::centre}, 0}};
    if (begin(start, walk))
      while (turn(walk) && straight(walk)) {
      }
  }
  const DriveTables& tables() const { return tables_; }

  DriveTime rolling(const DriveNode& node, std::size_t lane) const {
    if (!search_->passable(half_point(node))) return no_time;
    return search_->rolling(number(node), lane);
  }

 private:
  struct Placement {
    DriveNode node;
    DriveTime time = 0;
    std::size_t lane = 0;
  };
  /// The state while a route is followed: where it has come to, and in which lane.
  template <class Visit>
  struct Walk {
    Visit& visit;
    DriveTime time;  ///< of the whole route
    Placement here;
  };

  int number(const DriveNode& node) const { return search_->node(half_point(node), eighths(node)); }
  bool is_goal(HalfPoint point) const {
    return point.x % 2 != 0 && point.y % 2 != 0 && goals_.contains({(point.x - 1) / 2, (point.y - 1) / 2});
  }

  /// Calls visit(units, lane, time of the straight, time after it) for each straight that a route may begin with: up to
  /// a turn that begins in that lane, or up to a goal, with the lane no_lane.
  template <class Visit>
  void each_start(Pose start, Visit visit) const {
    const int node = number({start.cell, start.heading, Place::centre});
    for (int units = 0, run = search_->run(node); units <= run; ++units) {
      if (is_goal(search_->point(node + units))) visit(units, no_lane, tables_.whole_way(units, (run - units) / 2), 0);
      for (std::size_t lane = 0; lane < tables_.along.count(); ++lane)
        visit(units, lane, tables_.start_to(units, lane), search_->turning(node + units, lane, no_time));
    }
  }

  /// Visits the first straight; returns whether the route goes on after it.
  template <class Visit>
  bool begin(Pose start, Walk<Visit>& walk) const {
    int chosen = -1;
    std::size_t chosen_lane = 0;
    DriveTime first_time = 0;
    each_start(start, [&](int units, std::size_t lane, DriveTime first, DriveTime rest) {
      if (chosen >= 0 || first + rest != walk.time) return;
      chosen = units;
      chosen_lane = lane;
      first_time = first;
    });
    add_straight(walk, chosen, first_time);
    walk.here.lane = chosen_lane;
    return chosen_lane != no_lane;
  }

  template <class Visit>
  void add_straight(Walk<Visit>& walk, int units, DriveTime time) const {
    const int direction = eighths(walk.here.node);
    HalfPoint point = half_point(walk.here.node);
    point = {point.x + units * drive::unit(direction).x, point.y + units * drive::unit(direction).y};
    const DriveNode to = node_at(point, direction);
    if (units > 0 || time > 0)
      walk.visit(DriveSegment{DriveSegment::Kind::straight, walk.here.node, to, walk.here.time, walk.here.time + time,
                              units, 0, false});
    walk.here.node = to;
    walk.here.time += time;
  }

  /// Visits a turn that begins here, and goes to its end; false if there is none.
  template <class Visit>
  bool turn(Walk<Visit>& walk) const {
    const DriveNode& here = walk.here.node;
    const int node = number(here);
    const DriveTime rest = walk.time - walk.here.time;
    for (unsigned bits = search_->turns(node); bits != 0; bits &= bits - 1) {
      const auto bit = static_cast<unsigned>(std::countr_zero(bits));
      const Turn turn = drive::turn_of(bit, here.diagonal(), here.place == Place::edge);
      const int to = search_->leap(node, bit);
      for (std::size_t i = first_[static_cast<std::size_t>(turn)]; i < first_[static_cast<std::size_t>(turn) + 1];
           ++i) {
        const DrivenTurn& driven = tables_.turns[i];
        if (driven.from != walk.here.lane || driven.time + search_->rolling(to, driven.to) != rest) continue;
        add_turn(walk, i, to, bit);
        return true;
      }
    }
    return false;
  }

  template <class Visit>
  void add_turn(Walk<Visit>& walk, std::size_t turn, int to, unsigned bit) const {
    const DrivenTurn& driven = tables_.turns[turn];
    const int after = search_->direction(to);
    const unsigned change = static_cast<unsigned>(after - eighths(walk.here.node)) & 7U;
    const bool left = change == 4 ? bit % 2 == 0 : change > 4;
    const DriveNode there = node_at(search_->point(to), after);
    const DriveTime end = walk.here.time + driven.time;
    walk.visit(DriveSegment{DriveSegment::Kind::turn, walk.here.node, there, walk.here.time, end, 0,
                            static_cast<std::uint16_t>(turn), left});
    walk.here = {there, end, driven.to};
  }

  /// Visits the straight that begins here, perhaps of no length; returns whether the route goes on after it.
  template <class Visit>
  bool straight(Walk<Visit>& walk) const {
    const bool diagonal = walk.here.node.diagonal();
    const StraightTimes& table = diagonal ? tables_.diagonal : tables_.along;
    const int node = number(walk.here.node);
    const DriveTime rest = walk.time - walk.here.time;
    for (int units = 0, run = search_->run(node); units <= run; ++units) {
      if (!diagonal && is_goal(search_->point(node + units)) &&
          tables_.finish_from(units, walk.here.lane, (run - units) / 2) == rest) {
        add_straight(walk, units, rest);
        return false;
      }
      for (std::size_t lane = 0; lane < table.count(); ++lane) {
        const DriveTime time = table.at(units, walk.here.lane, lane);
        if (time > rest || search_->turning(node + units, lane, rest - time) != rest - time) continue;
        add_straight(walk, units, time);
        walk.here.lane = lane;
        return true;
      }
    }
    return false;
  }

  static constexpr std::size_t no_lane = ~std::size_t{0};

  Size size_;
  const DriveTables& tables_;
  const std::array<std::size_t, all_turns.size() + 1>& first_;
  CellSet goals_;
  drive::SearchInPlace search_;
};

std::size_t RouteTables::bytes_for(Size size) const {
  return kept_bytes_for(size) + parts_->searches->bytes(size).scratch;
}
std::size_t RouteTables::kept_bytes_for(Size size) const {
  return FastestRoutes::Search::own_bytes() + parts_->searches->bytes(size).kept;
}
std::size_t RouteTables::table_bytes(Size size) const {
  const DriveTables& tables = parts_->tables;
  const auto times = [](const std::vector<DriveTime>& list) { return sizeof(DriveTime) * list.size(); };
  return parts_->searches->table_bytes() + times(tables.along.between) + times(tables.diagonal.between) +
         times(tables.start) + times(tables.finish) + times(tables.whole) + sizeof(DrivenTurn) * tables.turns.size() +
         sizeof(std::uint16_t) * (drive::is_small(size) ? parts_->leaps.small : parts_->leaps.large).size();
}

MemoryLayout RouteTables::layout(Size size) const {
  MemoryLayout layout = parts_->searches->layout(size);
  std::size_t other = bytes_for(size);
  for (const MemoryPart& part : layout) other -= part.bytes;
  layout.push_back({"other", other});
  return layout;
}

void FastestRoutes::End::operator()(Search* search) const { search->~Search(); }

FastestRoutes::FastestRoutes(Size size, std::shared_ptr<const RouteTables> tables, std::span<std::byte> memory)
    : tables_(std::move(tables)) {
  assert(memory.size() >= tables_->bytes_for(size));
  search_.reset(new (memory.data()) Search(size, *tables_->parts_, memory.data() + Search::own_bytes()));
}
FastestRoutes::FastestRoutes(Size size, std::shared_ptr<const RouteTables> tables)
    : tables_(std::move(tables)),
      memory_(new std::byte[tables_->bytes_for(size)]),
      search_(new (memory_.get()) Search(size, *tables_->parts_, memory_.get() + Search::own_bytes())) {}
FastestRoutes::FastestRoutes(Size size, const DriveTables& tables)
    : FastestRoutes(size, std::make_shared<const RouteTables>(tables, size)) {}
FastestRoutes::~FastestRoutes() = default;
FastestRoutes::FastestRoutes(FastestRoutes&&) noexcept = default;

void FastestRoutes::fill(const WallSet& passages, const CellSet& goals) { search_->fill(passages, goals); }
void FastestRoutes::fill_for(Pose start, const WallSet& passages, const CellSet& goals, DriveTime limit) {
  search_->fill_for(start, passages, goals, limit);
}
void FastestRoutes::aim(Pose start, const WallSet& passages, DriveTime latest) {
  search_->aim(start, passages, latest);
}
DriveTime FastestRoutes::time_from(Pose start) const { return search_->time_from(start); }
void FastestRoutes::route_from(Pose start, DriveRoute& route) const {
  route.segments.clear();
  route.time = search_->time_from(start);
  search_->follow(start, route.time, [&](const DriveSegment& segment) { route.segments.push_back(segment); });
}
WallSet FastestRoutes::walls_from(Pose start) const {
  NeededWalls walls(search_->tables());
  search_->follow(start, search_->time_from(start), [&](const DriveSegment& segment) { walls.pass(segment); });
  return walls.all();
}
DriveTime FastestRoutes::rolling(const DriveNode& node, std::size_t lane) const { return search_->rolling(node, lane); }

WallSet walls_of(const DriveRoute& route) {
  WallSet walls;
  for (const DriveSegment& segment : route.segments) pass(segment, walls);
  return walls;
}

WallSet walls_needed_by(const DriveRoute& route, const DriveTables& tables) {
  NeededWalls walls(tables);
  for (const DriveSegment& segment : route.segments) walls.pass(segment);
  return walls.all();
}

}  // namespace labmouse
