#include "labmouse/lab/bounds/mms_bound.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <string_view>
#include <utility>

#include "labmouse/external/mms/half_pose.hpp"

namespace labmouse {
namespace {

// Costs are integers in units of 1/20 of a point of the score. A point of the run counts 1 for the run and 1/10 for the
// total: 22 units.
constexpr int points = 20, run_point = 22, start_turn = 2;

/// Cost of a move of that many half steps: its effective distance times run_point.
constexpr int cost_of_move(int half_steps) {
  return half_steps <= 2 ? half_steps * run_point : (half_steps + 2) * run_point / 2;
}

struct Turn {
  int eighths;
  std::string_view command;
};
constexpr Turn turns[] = {{2, "turnRight"}, {-2, "turnLeft"}, {1, "turnRight45"}, {-1, "turnLeft45"}};

/// Dijkstra's algorithm (1959) over poses, from the start to the nearest pose in a goal.
class Search {
 public:
  explicit Search(const Maze& maze)
      : maze_(maze),
        goals_(mms_goals(maze.size())),
        columns_(2 * maze.size().width + 1),
        nodes_(static_cast<std::size_t>(columns_) * (2 * maze.size().height + 1) * 8) {
    reach(HalfPose{}, 0, 0, 0);
    while (!open_.empty() && !end_) expand();
  }

  /// The least cost; nullopt where no goal can be reached.
  std::optional<int> cost() const {
    if (!end_) return std::nullopt;
    return nodes_[*end_].cost;
  }

  /// The commands of the way to the goal.
  std::vector<std::string> commands() const {
    std::vector<std::string> lines;
    if (!end_) return lines;
    for (std::size_t at = *end_; nodes_[at].cost > 0; at = nodes_[at].parent) lines.push_back(command_to(at));
    std::reverse(lines.begin(), lines.end());
    return lines;
  }

 private:
  struct Node {
    int cost = std::numeric_limits<int>::max();
    std::size_t parent = 0;
    int half_steps = 0;  ///< of the move that led here; 0 for a turn
  };

  std::size_t index(const HalfPose& pose) const {
    return static_cast<std::size_t>(pose.place.y * columns_ + pose.place.x) * 8 +
           static_cast<std::size_t>(pose.heading);
  }
  HalfPose pose(std::size_t index) const {
    const int place = static_cast<int>(index / 8);
    return {{place % columns_, place / columns_}, static_cast<Compass>(index % 8)};
  }

  void reach(const HalfPose& to, int cost, std::size_t parent, int half_steps) {
    Node& node = nodes_[index(to)];
    if (cost >= node.cost) return;
    node = {cost, parent, half_steps};
    open_.push({cost, index(to)});
  }

  void expand() {
    const auto [cost, at] = open_.top();
    open_.pop();
    if (cost > nodes_[at].cost) return;
    const HalfPose from = pose(at);
    if (goals_.contains(cell_of(from.place))) {
      end_ = at;
      return;
    }
    const int turn_cost = from.place == HalfPose{}.place ? start_turn : run_point;
    for (const Turn& turn : turns) reach({from.place, turned(from.heading, turn.eighths)}, cost + turn_cost, at, 0);
    HalfPose to = from;
    for (int half_steps = 1; !blocked(maze_, to.place, to.heading); ++half_steps) {
      to.place = half_step(to.place, to.heading);
      reach(to, cost + cost_of_move(half_steps), at, half_steps);
    }
  }

  std::string command_to(std::size_t at) const {
    const Node& node = nodes_[at];
    if (node.half_steps > 0) {
      return node.half_steps % 2 == 0 ? "moveForward " + std::to_string(node.half_steps / 2)
                                      : "moveForwardHalf " + std::to_string(node.half_steps);
    }
    const auto* turn = std::find_if(std::begin(turns), std::end(turns), [&](const Turn& candidate) {
      return turned(pose(node.parent).heading, candidate.eighths) == pose(at).heading;
    });
    return std::string(turn->command);
  }

  const Maze& maze_;
  CellSet goals_;
  int columns_;
  std::vector<Node> nodes_;
  using Entry = std::pair<int, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
  std::optional<std::size_t> end_;
};

/// Whether the start is a goal. Then a turn there finishes a run, and adds 1/10 to the score by the total.
bool starts_in_goal(const Maze& maze) { return mms_goals(maze.size()).contains(Cell{}); }

}  // namespace

MmsBound mms_bound_of(const Maze& maze) {
  if (starts_in_goal(maze)) return {0.0, static_cast<double>(start_turn) / points};
  const auto cost = Search(maze).cost();
  if (!cost) return {};
  // A run costs a multiple of run_point / 2, and the turns before it less than run_point / 2: the division removes
  // them.
  const int half_points = *cost / (run_point / 2);
  return {half_points / 2.0, static_cast<double>(*cost) / points};
}

std::vector<std::string> mms_best_commands(const Maze& maze) {
  if (starts_in_goal(maze)) return {"turnRight"};
  return Search(maze).commands();
}

}  // namespace labmouse
