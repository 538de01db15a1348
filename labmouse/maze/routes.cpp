#include "labmouse/maze/routes.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace labmouse {
namespace {

constexpr int unreached = -1;

// A number for each cell of a maze.
class CellNumbers {
 public:
  explicit CellNumbers(Size size) : size_(size), numbers_(static_cast<std::size_t>(size.area()), unreached) {}
  int& operator[](Cell cell) { return numbers_[static_cast<std::size_t>(size_.index(cell))]; }

 private:
  Size size_;
  std::vector<int> numbers_;
};

struct Search {
  /// Cells in the order in which they were reached.
  std::vector<Cell> order;
  CellNumbers distance;
};

// Breadth-first search from the start, with steps of at most `longest` cells.
Search search_from_start(const Maze& maze, int longest) {
  Search search{{maze.start()}, CellNumbers(maze.size())};
  search.distance[maze.start()] = 0;
  for (std::size_t next = 0; next < search.order.size(); ++next) {
    const Cell from = search.order[next];
    for (const Heading heading : all_headings) {
      Cell to = from;
      for (int cells = 0; cells < longest && maze.is_open(to, heading); ++cells) {
        to = neighbour(to, heading);
        if (search.distance[to] != unreached) continue;
        search.distance[to] = search.distance[from] + 1;
        search.order.push_back(to);
      }
    }
  }
  return search;
}

// The goal that the search reached first.
std::optional<Cell> first_goal(const Maze& maze, const Search& search) {
  for (const Cell cell : search.order)
    if (maze.is_goal(cell)) return cell;
  return std::nullopt;
}

constexpr std::uint64_t saturating_sum(std::uint64_t a, std::uint64_t b) {
  constexpr auto most = std::numeric_limits<std::uint64_t>::max();
  return a > most - b ? most : a + b;
}

// Counts the shortest sequences of steps to any goal, by adding up those to each cell in the search's order.
std::uint64_t count_runs(const Maze& maze, Search& search, int longest, int strides) {
  std::vector<std::uint64_t> runs(static_cast<std::size_t>(maze.size().area()), 0);
  const auto runs_to = [&](Cell cell) -> std::uint64_t& {
    return runs[static_cast<std::size_t>(maze.size().index(cell))];
  };
  runs_to(maze.start()) = 1;
  std::uint64_t count = 0;
  for (const Cell from : search.order) {
    if (search.distance[from] == strides && maze.is_goal(from)) count = saturating_sum(count, runs_to(from));
    for (const Heading heading : all_headings) {
      Cell to = from;
      for (int cells = 0; cells < longest && maze.is_open(to, heading); ++cells) {
        to = neighbour(to, heading);
        if (search.distance[to] == search.distance[from] + 1) runs_to(to) = saturating_sum(runs_to(to), runs_to(from));
      }
    }
  }
  return count;
}

// The cells of a shortest route from the start to the cell. The search must have gone one cell per step.
std::vector<Cell> way_to(const Maze& maze, Search& search, Cell cell) {
  std::vector<Cell> way = {cell};
  while (way.back() != maze.start()) {
    const Cell last = way.back();
    for (const Heading heading : all_headings) {
      const Cell before = neighbour(last, heading);
      if (!maze.is_open(last, heading) || search.distance[before] != search.distance[last] - 1) continue;
      way.push_back(before);
      break;
    }
  }
  std::reverse(way.begin(), way.end());
  return way;
}

// Whether a detour leaves the route at the cell, and returns to it at another cell or enters a goal. `seen` collects
// the visited cells beside the route. A passage between two successive cells of the route is no detour.
bool has_detour(const Maze& maze, Search& search, const CellSet& way, Cell from, CellSet& seen) {
  const auto follows = [&](Cell a, Cell b) {
    const int difference = search.distance[a] - search.distance[b];
    return way.contains(a) && way.contains(b) && (difference == 1 || difference == -1);
  };
  std::vector<Cell> cells = {from};
  while (!cells.empty()) {
    const Cell cell = cells.back();
    cells.pop_back();
    for (const Heading heading : all_headings) {
      const Cell next = neighbour(cell, heading);
      if (!maze.is_open(cell, heading) || next == from || follows(cell, next)) continue;
      if (way.contains(next) || maze.is_goal(next)) return true;
      if (seen.contains(next)) continue;
      seen.insert(next);
      cells.push_back(next);
    }
  }
  return false;
}

}  // namespace

CellSet reachable_cells(const Maze& maze) {
  CellSet cells;
  for (const Cell cell : search_from_start(maze, 1).order) cells.insert(cell);
  return cells;
}

std::optional<int> shortest_in_cells(const Maze& maze) {
  Search search = search_from_start(maze, 1);
  const auto goal = first_goal(maze, search);
  if (!goal) return std::nullopt;
  return search.distance[*goal];
}

std::optional<ShortestStrides> shortest_in_strides(const Maze& maze, int longest) {
  assert(longest >= 1);
  if (maze.is_goal(maze.start())) return ShortestStrides{1, 1};
  Search search = search_from_start(maze, longest);
  const auto goal = first_goal(maze, search);
  if (!goal) return std::nullopt;
  const int strides = search.distance[*goal];
  return ShortestStrides{strides, count_runs(maze, search, longest, strides)};
}

bool has_several_routes(const Maze& maze) {
  Search search = search_from_start(maze, 1);
  const auto goal = first_goal(maze, search);
  if (!goal) return false;
  // A second route must leave the first one somewhere, and meet it again at another cell or enter a goal.
  const std::vector<Cell> way = way_to(maze, search, *goal);
  CellSet on_way;
  for (const Cell cell : way) on_way.insert(cell);
  CellSet seen;
  return std::any_of(way.begin(), way.end() - 1,
                     [&](Cell cell) { return has_detour(maze, search, on_way, cell, seen); });
}

std::vector<Cell> shortest_way(const Maze& maze) {
  Search search = search_from_start(maze, 1);
  const auto goal = first_goal(maze, search);
  if (!goal) return {};
  return way_to(maze, search, *goal);
}

}  // namespace labmouse
