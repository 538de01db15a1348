// Contest mazes: to the official rules (labmouse/maze/contest_rules.hpp), which know 16×16 and 32×32; other even sides
// give mazes that keep all of those rules but the size.
//
// Method: grow walls (labmouse/maze/generators/wall_growth.hpp) from the border, the closed goal room, the wall beside
// the start and some islands. By construction then every cell is connected, every post but the goal's middle has a
// wall, the start has three, and the walls of the goal room never touch those of the border, so that no wall follower
// comes to them. Last, the goal room gets its entrance where the way is long: the mouse that runs straight to the
// centre stands before a closed wall; and pieces of wall are moved until the way is as long as the dice asked for, two
// to five sides of the maze, or no longer. Loops open walls wherever the rules allow. Why it always ends: should no
// entrance have several routes, a second growth lets no wall start at the goal room. The twelve cells around the room
// then form a ring; the ways from the start come to it in at most one of the eight cells before a possible entrance, or
// else in several, and two ways lead around to each of the other cells. Source: our own. Lengths of way (median 61
// cells at 16x16), loops (10) and straights (93) are near those of 260 real contest mazes (54, 13 and 106); dead ends
// are more (39 against 27). Measured in 2026 over 1,000 seeds.
#include <cassert>
#include <optional>

#include "labmouse/maze/generators/contest_changes.hpp"
#include "labmouse/maze/generators/loops.hpp"
#include "labmouse/maze/generators/wall_growth.hpp"
#include "labmouse/maze/routes.hpp"

namespace labmouse {
namespace {

// Entrances that are compared before the one with the longest way is taken: always the longest would be no surprise.
constexpr int compared_entrances = 4;

// Below it the goal room and its surroundings leave too little maze to choose a way in.
constexpr int least_side = 12;

// Its posts, one more than its cells, have to fit into a row of bits.
constexpr int largest_side = max_side - 2;

enum class GoalRoom { may_have_arms, bare };

std::string_view refuses(const GeneratorOrder& order) {
  if (const auto reason = refuses_out_of_range(order); !reason.empty()) return reason;
  if (order.size.width == order.size.height && order.size.width % 2 == 0 && order.size.width >= least_side &&
      order.size.width <= largest_side)
    return {};
  return "a contest maze must be a square with an even side from 12x12 to 62x62; choose such a size, or another kind "
         "of maze";
}

// The walls around the goal room, each on its goal cell's side.
std::vector<Wall> walls_around(const CellSet& goals) {
  std::vector<Wall> walls;
  goals.for_each([&](Cell cell) {
    for (const Heading side : all_headings)
      if (!goals.contains(neighbour(cell, side))) walls.push_back({cell, side});
  });
  return walls;
}

// A maze whose goal room has no entrance yet.
MazeDraft grown_walls(Size size, GoalRoom goal_room, Dice& dice) {
  MazeDraft draft(size, MazeDraft::Inside::open);
  const CellSet goals = centre_of(size);
  goals.for_each([&](Cell cell) { draft.add_goal(cell); });
  for (const Wall wall : walls_around(goals)) draft.close(wall.cell, wall.side);
  draft.close(draft.start(), Heading::east);

  const Post middle{size.width / 2, size.height / 2};
  const int reach = goal_room == GoalRoom::bare ? 1 : 0;
  CellSet barren;
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx) barren.insert({middle.x + dx, middle.y + dy});

  WallGrowth growth(draft, dice, barren);
  growth.plant_islands(size.area() / 64 + dice.below(size.area() / 24));
  growth.fill();
  return draft;
}

// Opens an entrance with several routes and a long way to it; false where no entrance has several routes.
bool open_entrance(MazeDraft& draft, Dice& dice) {
  std::vector<Wall> lots = walls_around(draft.goals());
  std::optional<Wall> best;
  int longest = 0;
  for (int compared = 0; compared < compared_entrances && !lots.empty();) {
    const Wall wall = draw(lots, dice);
    MazeDraft entered = draft;
    entered.open(wall.cell, wall.side);
    const Maze maze(entered);
    if (!has_several_routes(maze)) continue;
    ++compared;
    if (const int cells = shortest_in_cells(maze).value_or(0); cells > longest) {
      longest = cells;
      best = wall;
    }
  }
  if (best) draft.open(best->cell, best->side);
  return best.has_value();
}

Maze make_contest(const GeneratorOrder& order) {
  Dice dice(order.seed);
  MazeDraft draft = grown_walls(order.size, GoalRoom::may_have_arms, dice);
  if (!open_entrance(draft, dice)) {
    // Not seen in 6,000 mazes, but possible: an arm may wind around the whole goal room.
    draft = grown_walls(order.size, GoalRoom::bare, dice);
    [[maybe_unused]] const bool opened = open_entrance(draft, dice);
    assert(opened);
  }
  lengthen_way(draft, dice, order.size.width * (2 + dice.below(4)));
  open_loops(draft, order, may_open_in_contest);
  return Maze(draft);
}

}  // namespace

constinit const Generator contest_generator = {
    .name = "contest",
    .summary = "follows the official contest rules (16x16, 32x32), or the same pattern on other even squares",
    .refuses = refuses,
    .make = make_contest,
};

}  // namespace labmouse
