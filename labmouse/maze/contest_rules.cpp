#include "labmouse/maze/contest_rules.hpp"

#include <algorithm>
#include <array>

#include "labmouse/maze/post.hpp"
#include "labmouse/maze/routes.hpp"
#include "labmouse/maze/wall_follower.hpp"

namespace labmouse {
namespace {

std::string name_of(Cell cell) { return "(" + std::to_string(cell.x) + "," + std::to_string(cell.y) + ")"; }

std::string name_of(Wall wall) { return std::string(name_of(wall.side)) + " of " + name_of(wall.cell); }

// "(1,2), (3,4), (5,6) and 7 more"
template <class Place>
std::string list_of(const std::vector<Place>& places) {
  constexpr std::size_t most_named = 4;
  std::string list;
  for (std::size_t i = 0; i < std::min(places.size(), most_named); ++i)
    list += (i == 0 ? "" : ", ") + name_of(places[i]);
  if (places.size() > most_named) list += " and " + std::to_string(places.size() - most_named) + " more";
  return list;
}

// Each of these returns what is wrong; empty where the rule is kept.

std::string wrong_size(const Maze& maze) {
  const auto [width, height] = maze.size();
  if (width == height && (width == 16 || width == 32)) return {};
  return std::to_string(width) + "x" + std::to_string(height) + " instead of 16x16 or 32x32";
}

// A Maze has no way to open its border; the rule is listed because a reader looks for it.
std::string gap_in_border(const Maze&) { return {}; }

std::string wrong_start(const Maze& maze) {
  const auto [width, height] = maze.size();
  const Cell start = maze.start();
  if ((start.x != 0 && start.x != width - 1) || (start.y != 0 && start.y != height - 1))
    return "the start " + name_of(start) + " is not in a corner";
  const auto open =
      std::count_if(all_headings.begin(), all_headings.end(), [&](Heading side) { return maze.is_open(start, side); });
  if (open == 1) return {};
  return "the start " + name_of(start) + " has " + std::to_string(4 - open) + " walls instead of 3";
}

std::string walls_in_goal_room(const Maze& maze) {
  const Size size = maze.size();
  if (maze.goals().count() != 4 || maze.goals() != centre_of(size))
    return "the goals are not the 2x2 cells in the centre";
  std::vector<Wall> walls;
  maze.goals().for_each([&](Cell cell) {
    for (const Heading side : {Heading::north, Heading::east})
      if (maze.is_goal(neighbour(cell, side)) && !maze.is_open(cell, side)) walls.push_back(wall_at(cell, side));
  });
  return walls.empty() ? std::string{} : "walls inside: " + list_of(walls);
}

std::string wrong_entrances(const Maze& maze) {
  std::vector<Wall> entrances;
  maze.goals().for_each([&](Cell cell) {
    for (const Heading side : all_headings)
      if (maze.is_open(cell, side) && !maze.is_goal(neighbour(cell, side))) entrances.push_back({cell, side});
  });
  if (entrances.size() == 1) return {};
  return entrances.empty() ? "none" : std::to_string(entrances.size()) + " instead of one: " + list_of(entrances);
}

std::string posts_without_wall(const Maze& maze) {
  std::vector<Post> posts;
  for (int y = 1; y < maze.size().height; ++y)
    for (int x = 1; x < maze.size().width; ++x) {
      const Post post{x, y};
      const bool in_goal =
          maze.is_goal({x, y}) && maze.is_goal({x - 1, y}) && maze.is_goal({x, y - 1}) && maze.is_goal({x - 1, y - 1});
      const auto open = [&](Heading heading) { return maze.open_walls().contains(wall_from(post, heading)); };
      if (!in_goal && std::all_of(all_headings.begin(), all_headings.end(), open)) posts.push_back(post);
    }
  return posts.empty() ? std::string{} : "no wall at the south-west corner of " + list_of(posts);
}

std::string unreachable_goal(const Maze& maze) {
  return shortest_in_cells(maze) ? "" : "no way from the start " + name_of(maze.start());
}

std::string followed_by(const Maze& maze, Hand hand) {
  return wall_follower_arrives(maze, hand) ? "reaches the goal" : "";
}

std::string too_few_routes(const Maze& maze) {
  return has_several_routes(maze) ? "" : "fewer than two routes from the start to the goal";
}

RuleFinding finding(std::string_view name, std::string wrong) { return {name, wrong.empty(), std::move(wrong)}; }

}  // namespace

std::vector<RuleFinding> check_contest_rules(const Maze& maze) {
  return {finding("size", wrong_size(maze)),
          finding("border", gap_in_border(maze)),
          finding("start", wrong_start(maze)),
          finding("goal room", walls_in_goal_room(maze)),
          finding("entrance", wrong_entrances(maze)),
          finding("posts", posts_without_wall(maze)),
          finding("goal reachable", unreachable_goal(maze)),
          finding("left wall follower", followed_by(maze, Hand::left)),
          finding("right wall follower", followed_by(maze, Hand::right)),
          finding("routes", too_few_routes(maze))};
}

bool keeps_contest_rules(const Maze& maze) {
  const auto findings = check_contest_rules(maze);
  return std::all_of(findings.begin(), findings.end(), [](const RuleFinding& rule) { return rule.passed; });
}

}  // namespace labmouse
