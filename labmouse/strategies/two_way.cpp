// two-way: A* to the goal and, with the start as the goal, back again.
//
// Limits: no path is shown to be shortest, and legs are compared in cells, not in strides. It does not watch the
// budget: in a large maze the way back may not fit.
// Choices: the report does not state the order of equally good cells. The order of a Python hash table (HashedCells)
// reproduces the scores of all its stages; orders of directions do not. `ties` only orders the neighbours. The mouse
// leaves the goal by the way it came, and lists no other neighbour of it, as the 36 steps back in maze 1 require. A
// dead end that it enters backwards shows an open way ahead, so it is not marked. Ties between legs and paths go to the
// way there. The first stride is one cell shorter than others, as the 30 steps of maze 3 require. If the rear of the
// start is not the border, the mouse turns first to see it.
#include <algorithm>
#include <array>
#include <limits>

#include "labmouse/mouse/explorer.hpp"
#include "labmouse/mouse/hashed_cells.hpp"
#include "labmouse/mouse/legs.hpp"
#include "labmouse/mouse/search_tree.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {
namespace {

class TwoWay final : public Explorer {
 public:
  TwoWay(const Briefing& briefing, const Settings& settings)
      : Explorer(briefing),
        bias_(settings.real("bias")),
        join_legs_(settings.flag("join_legs")),
        merge_strides_(settings.flag("merge_strides")),
        ties_(settings.choice("ties")),
        manhattan_(briefing.size, strides(1)),
        tree_(briefing.size, 1, ties_),
        unvisited_(briefing.size, cell_order(settings.choice("order")), CellTable::map, CellKey::row_column),
        nodes_(static_cast<std::size_t>(briefing.size.area())) {
    for (Path* path : {&plan_, &way_there_, &way_back_, &route_}) path->reserve(nodes_.size());
    begin_way(briefing.goals);
  }

  StrategyReport report() override { return {.counters = counters_}; }

 private:
  /// A* data of a cell: steps from the beginning of the present way, and the previous cell.
  struct Node {
    int cost = unreachable;
    Cell parent;
  };
  enum Count : unsigned { discovered_there, visited_there, discovered_back, visited_back };

  Action explore() override {
    const Cell here = pose().cell;
    const Cell start = briefing().start.cell;
    // The start may be a goal: it counts as entered only when a step ends there.
    if (!goal_entered() && briefing().goals.contains(here)) return Action::step(0, 0);
    if (sees_too_little()) return Action::step(90, 0);
    visit(here);
    if (goal_entered() && !returning_) {
      turn_back();
      if (here != start) return go(came_from_);
    }
    if (returning_ && here == start) return finish();
    if (plan_.empty() && !choose()) return Action::forfeit(ForfeitReason::no_route);
    const Cell next = plan_.back();
    plan_.pop_back();
    return go(next);
  }

  /// Whether a side of the present cell was never seen: that can only be the start's rear.
  bool sees_too_little() const {
    const WallSet unknown = knowledge().unknown();
    const Cell here = pose().cell;
    return std::any_of(all_headings.begin(), all_headings.end(),
                       [&](Heading side) { return unknown.contains(wall_at(here, side)); });
  }

  Action go(Cell next) {
    came_from_ = pose().cell;
    return move_in(pose().heading, move_between(pose().cell, next).direction, 1);
  }

  // The map of this way.

  /// Clears the search, and begins a new way at the present cell.
  void begin_way(const CellSet& towards) {
    manhattan_.fill(WallSet::all(briefing().size), towards);
    nodes_.assign(nodes_.size(), Node{});
    node(pose().cell) = {0, pose().cell};
    visited_now_ = {};
    unvisited_.clear();
    plan_.clear();
  }

  void visit(Cell here) {
    visited_now_.insert(here);
    unvisited_.erase(here);
    for (const Heading direction : ties_.from(pose().heading))
      if (open(here, direction)) discover(neighbour(here, direction), here);
    const bool arrived = goal_entered() && !returning_;
    if (seen() == Sighting{} && !arrived) mark_dead_end(here);
    count();
  }

  void discover(Cell cell, Cell from) {
    discovered_.insert(cell);
    if (visited_now_.contains(cell) || dead_ends_.contains(cell)) return;
    unvisited_.insert(cell);
    if (node(from).cost + 1 < node(cell).cost) node(cell) = {node(from).cost + 1, from};
  }

  void mark_dead_end(Cell cell) {
    while (cell != briefing().start.cell && ways_from(cell) < 3) {
      dead_ends_.insert(cell);
      if (node(cell).parent == cell) return;
      cell = node(cell).parent;
    }
  }

  int ways_from(Cell cell) const {
    return static_cast<int>(
        std::count_if(all_headings.begin(), all_headings.end(), [&](Heading side) { return open(cell, side); }));
  }

  /// Plans the way to the unvisited cell with the least length + bias × Manhattan distance; false if none is left.
  bool choose() {
    // On the way back, cells known from the way there may be passed; dead ends only if the mouse has visited them on
    // this way.
    CellSet shunned = dead_ends_;
    shunned -= visited_now_;
    CellSet through = visited();
    through -= shunned;
    tree_.grow(knowledge().open(), pose(), through);
    double least = std::numeric_limits<double>::infinity();
    Cell target = pose().cell;
    unvisited_.for_each([&](Cell cell) {
      if (!tree_.reaches(cell)) return;
      const double price = tree_.distance(cell) + bias_ * manhattan_.at(cell);
      if (price >= least) return;
      least = price;
      target = cell;
    });
    for (Cell cell = target; cell != pose().cell; cell = tree_.before(cell)) plan_.push_back(cell);
    return !plan_.empty();
  }

  // The two ways, and the route made of them.

  /// Saves the way there, and begins the way back with the last step reversed.
  void turn_back() {
    returning_ = true;
    keep_way(way_there_);
    std::reverse(way_there_.begin(), way_there_.end());
    CellSet start;
    start.insert(briefing().start.cell);
    begin_way(start);
    visited_now_.insert(pose().cell);
    if (pose().cell != briefing().start.cell) node(came_from_) = {1, pose().cell};
  }

  /// Writes the path from the present cell along the parents.
  void keep_way(Path& path) const {
    Cell cell = pose().cell;
    path.assign(1, cell);
    while (node(cell).parent != cell) path.push_back(cell = node(cell).parent);
  }

  Action finish() {
    keep_way(way_back_);
    if (join_legs_)
      join_legs(way_there_, way_back_, route_);
    else
      route_ = way_back_.size() < way_there_.size() ? way_back_ : way_there_;
    return Action::reset();
  }

  Action race() override {
    const std::size_t last = route_.size() - 1;
    if (raced_ == last) return Action::step(0, 0);
    const Heading direction = move_between(route_[raced_], route_[raced_ + 1]).direction;
    const int longest = merge_strides_ ? std::max(1, briefing().motion.longest - (raced_ == 0 ? 1 : 0)) : 1;
    int cells = 0;
    while (cells < longest && raced_ < last && route_[raced_ + 1] == neighbour(route_[raced_], direction)) {
      ++cells;
      ++raced_;
    }
    return move_in(pose().heading, direction, cells);
  }

  /// As the report counts: the start is not discovered, and the goal is not visited on the way back.
  void count() {
    CellSet found = discovered_;
    found.erase(briefing().start.cell);
    const int before = returning_ ? static_cast<int>(counters_[discovered_there].value) : 0;
    counters_[returning_ ? discovered_back : discovered_there].value = found.count() - before;
    counters_[returning_ ? visited_back : visited_there].value = visited_now_.count() - (returning_ ? 1 : 0);
  }

  bool open(Cell cell, Heading side) const { return knowledge().open().contains(wall_at(cell, side)); }
  Node& node(Cell cell) { return nodes_[static_cast<std::size_t>(briefing().size.index(cell))]; }
  const Node& node(Cell cell) const { return nodes_[static_cast<std::size_t>(briefing().size.index(cell))]; }

  double bias_;
  bool join_legs_;
  bool merge_strides_;
  TieOrder ties_;
  DistanceField manhattan_;
  SearchTree tree_;
  HashedCells unvisited_;
  std::vector<Node> nodes_;
  CellSet visited_now_;  ///< on this way
  CellSet discovered_;
  CellSet dead_ends_;
  Path plan_;  ///< in reverse: the next cell is at the back
  Path way_there_;
  Path way_back_;
  Path route_;
  std::size_t raced_ = 0;  ///< place of the mouse on the route
  Cell came_from_;
  bool returning_ = false;
  std::array<Counter, 4> counters_ = {{{"cells discovered on the way there"},
                                       {"cells visited on the way there"},
                                       {"cells discovered on the way back"},
                                       {"cells visited on the way back"}}};
};

constexpr std::array two_way_parameters = {
    Parameter::real("bias", "1.5", 0, 100,
                    "Weight of a cell of Manhattan distance to the goal against a step (no unit)."),
    Parameter::flag("join_legs", "yes", "Whether the speed run takes the shorter leg between crossings of both paths."),
    Parameter::flag(
        "merge_strides", "yes",
        "Whether the speed run takes the longest possible moves on straight legs, instead of one cell a step."),
    Parameter::choice("ties", "nesw", TieOrder::all,
                      "Order of the directions that decides between equally good neighbours."),
    Parameter::choice(
        "order", "python-2.7", all_cell_orders,
        "Order of the hash table of that Python version, or row by row (rows), in which equally good cells are tried."),
};

}  // namespace

constinit const BuiltinMouse two_way_mouse = {
    .name = "two-way",
    .summary = "A* to the goal and back; joins the shorter legs of both paths",
    .method =
        "A list holds the cells that have been discovered (they have an open wall to a visited cell) but not yet "
        "visited. The mouse goes, cell by cell, to the one with the lowest sum of the steps there, through visited "
        "cells, and bias times its Manhattan distance to the goal, and looks again. A cell's parent is the visited "
        "neighbour that was cheapest to reach from the beginning of the way, so parents lead from the goal back to "
        "the start. A cell from which no open wall is seen is a dead end: it and its parents, up to one with three "
        "open walls, are not listed again. In the goal, the list, the visits, the costs and the parents are cleared, "
        "but not the walls and dead ends, and the same search leads to the start. The speed run follows the shorter "
        "of the two paths or (join_legs) the shorter leg between each two of their crossings, one cell a step or "
        "(merge_strides) in strides.",
    .source =
        "Report 2 (Kapustin 2016), Implementation and Refinement; its first stage is "
        "bias=1:join_legs=no:merge_strides=no.",
    .parameters = two_way_parameters,
    .make = [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<TwoWay>(briefing, settings);
    },
};

}  // namespace labmouse
