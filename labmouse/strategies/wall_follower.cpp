// wall-left, wall-right: wall followers.
//
// Limits: never enters a goal whose walls are not connected to the border (an "island"), as in contest mazes.
#include "labmouse/mouse/explorer.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {
namespace {

constexpr std::string_view wall_follower_method =
    "In each cell it takes the first open side in the order hand side, ahead, other side; in a dead end it turns on "
    "the spot, away from the hand. At the goal it resets and takes the shortest route that it has seen.";

constexpr std::string_view wall_follower_source =
    "Folklore, older than the contests; the maze is a graph drawn in the plane, and its hand traces one face.";

class WallFollower final : public Explorer {
 public:
  /// `hand` is the side of the hand in quarter turns: -1 left, 1 right.
  WallFollower(const Briefing& briefing, int hand) : Explorer(briefing), hand_(hand) {}

 private:
  Action explore() override {
    if (goal_entered()) return Action::reset();
    for (const int side : {hand_, 0, -hand_})
      if (seen().towards(side) > 0) return Action::step(90 * side, 1);
    return Action::step(-90 * hand_, 0);
  }

  int hand_;
};

}  // namespace

constinit const BuiltinMouse wall_left_mouse = {
    .name = "wall-left",
    .summary = "keeps its left hand on the wall until the goal",
    .method = wall_follower_method,
    .source = wall_follower_source,
    .make = [](const Briefing& briefing, const Settings&) -> std::unique_ptr<Strategy> {
      return std::make_unique<WallFollower>(briefing, -1);
    },
};

constinit const BuiltinMouse wall_right_mouse = {
    .name = "wall-right",
    .summary = "keeps its right hand on the wall until the goal",
    .method = wall_follower_method,
    .source = wall_follower_source,
    .make = [](const Briefing& briefing, const Settings&) -> std::unique_ptr<Strategy> {
      return std::make_unique<WallFollower>(briefing, 1);
    },
};

}  // namespace labmouse
