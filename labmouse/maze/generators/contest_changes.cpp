#include "labmouse/maze/generators/contest_changes.hpp"

#include <cassert>
#include <optional>

#include "labmouse/maze/contest_rules.hpp"
#include "labmouse/maze/generators/loops.hpp"
#include "labmouse/maze/post.hpp"
#include "labmouse/maze/routes.hpp"

namespace labmouse {
namespace {

// Most mazes reach the requested length with these; they take a few milliseconds.
constexpr int trials = 150;

struct Ends {
  Post first;
  Post second;
};

// The far cell's south-west corner is one end of the wall; the other is one post further along it.
Ends ends_of(Wall wall) {
  const Post first = neighbour(wall.cell, wall.side);
  return {first, neighbour(first, wall.side == Heading::north ? Heading::east : Heading::north)};
}

// The closed walls at a post, including those of the border.
std::vector<Wall> walls_at(const MazeDraft& draft, Post post) {
  std::vector<Wall> walls;
  for (const Heading heading : all_headings)
    if (const Wall wall = wall_from(post, heading); !draft.open_walls().contains(wall)) walls.push_back(wall);
  return walls;
}

bool belongs_to_start_or_goal(const MazeDraft& draft, Wall wall) {
  for (const Cell cell : {wall.cell, neighbour(wall.cell, wall.side)})
    if (cell == draft.start() || draft.goals().contains(cell)) return true;
  return false;
}

// The wall between two neighbouring cells.
Wall wall_between(Cell a, Cell b) {
  for (const Heading heading : all_headings)
    if (neighbour(a, heading) == b) return wall_at(a, heading);
  assert(false);
  return {};
}

// Closes a passage of the route, and opens a wall at one of its posts instead; nothing if the drawn ones do not allow
// it.
std::optional<MazeDraft> with_a_piece_moved(const MazeDraft& draft, const std::vector<Cell>& way, Rng& rng) {
  const auto step = static_cast<std::size_t>(rng.below(static_cast<int>(way.size()) - 1));
  const Wall passage = wall_between(way[step], way[step + 1]);
  if (belongs_to_start_or_goal(draft, passage)) return std::nullopt;
  const auto [first, second] = ends_of(passage);
  std::vector<Wall> lots = walls_at(draft, rng.chance(1, 2) ? first : second);
  if (lots.empty()) return std::nullopt;
  const Wall wall = draw(lots, rng);
  MazeDraft moved = draft;
  moved.close(passage.cell, passage.side);
  if (on_border(wall, draft.size()) || !may_open_in_contest(moved, wall)) return std::nullopt;
  moved.open(wall.cell, wall.side);
  return moved;
}

}  // namespace

bool may_open_in_contest(const MazeDraft& draft, Wall wall) {
  if (belongs_to_start_or_goal(draft, wall)) return false;
  const auto [first, second] = ends_of(wall);
  return walls_at(draft, first).size() > 1 && walls_at(draft, second).size() > 1;
}

void lengthen_way(MazeDraft& draft, Rng& rng, int cells) {
  std::vector<Cell> way = shortest_way(Maze(draft));
  for (int trial = 0; trial < trials && static_cast<int>(way.size()) <= cells; ++trial) {
    const auto moved = with_a_piece_moved(draft, way, rng);
    if (!moved) continue;
    const Maze maze(*moved);
    std::vector<Cell> new_way = shortest_way(maze);
    if (new_way.size() < way.size() || reachable_cells(maze).count() < draft.size().area()) continue;
    if (!keeps_contest_rules(maze)) continue;
    draft = *moved;
    way = std::move(new_way);
  }
}

}  // namespace labmouse
