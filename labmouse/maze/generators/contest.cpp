// Contest mazes by the official rules (labmouse/maze/contest_rules.hpp), which are for 16×16 and 32×32. Mazes of other
// even sides keep all of those rules except the size.
//
// Method: walls grow (labmouse/maze/generators/wall_growth.hpp) from the border, the closed goal room, the wall beside
// the start and some islands. By construction every cell is then connected, every post but the goal's middle has a
// wall, and the start has three. The walls of the goal room never touch those of the border, so no wall follower
// reaches them. Then the goal room gets its entrance where the route is long: a mouse that runs straight to the centre
// meets a closed wall. Pieces of wall are moved until the route has at least a random length of two to five sides of
// the maze, or the trials are over. Last, loops open walls wherever the rules allow. It always ends: if no entrance has
// several routes, the walls grow again, and none may start at the goal room. The twelve cells around the room then form
// a ring. If the routes from the start enter the ring at one cell only, two ways around the ring lead to an entrance at
// any other of its cells; if they enter it at several cells, every entrance has two routes. Source: our own. Figures of
// 1,000 seeds at 16x16 (in brackets, those of 260 real contest mazes; 2026): median route 61 cells (54), 10 loops (13),
// 93 straights (106), 39 dead ends (27).
#include <cassert>
#include <optional>

#include "labmouse/maze/generators/contest_changes.hpp"
#include "labmouse/maze/generators/loops.hpp"
#include "labmouse/maze/generators/wall_growth.hpp"
#include "labmouse/maze/routes.hpp"

namespace labmouse {
namespace {

// Random entrances that are compared; the one with the longest route is taken. Comparing all would be too predictable.
constexpr int compared_entrances = 4;

// In a smaller maze the goal room and its surroundings leave too few cells for routes.
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

// The walls around the goal room, each named from its goal cell.
std::vector<Wall> walls_around(const CellSet& goals) {
  std::vector<Wall> walls;
  goals.for_each([&](Cell cell) {
    for (const Heading side : all_headings)
      if (!goals.contains(neighbour(cell, side))) walls.push_back({cell, side});
  });
  return walls;
}

// A maze whose goal room has no entrance yet.
MazeDraft grown_walls(Size size, GoalRoom goal_room, Rng& rng) {
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

  WallGrowth growth(draft, rng, barren);
  growth.plant_islands(size.area() / 64 + rng.below(size.area() / 24));
  growth.fill();
  return draft;
}

// Opens an entrance with several routes and a long way to it; false where no entrance has several routes.
bool open_entrance(MazeDraft& draft, Rng& rng) {
  std::vector<Wall> lots = walls_around(draft.goals());
  std::optional<Wall> best;
  int longest = 0;
  for (int compared = 0; compared < compared_entrances && !lots.empty();) {
    const Wall wall = draw(lots, rng);
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
  Rng rng(order.seed);
  MazeDraft draft = grown_walls(order.size, GoalRoom::may_have_arms, rng);
  if (!open_entrance(draft, rng)) {
    // Possible, but not seen in 6,000 mazes: a wall from the goal room may wind around all of it.
    draft = grown_walls(order.size, GoalRoom::bare, rng);
    [[maybe_unused]] const bool opened = open_entrance(draft, rng);
    assert(opened);
  }
  lengthen_way(draft, rng, order.size.width * (2 + rng.below(4)));
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
