#include "labmouse/lab/studies/folds.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <string_view>
#include <tuple>

#include "labmouse/chance/rng.hpp"
#include "labmouse/maze/symmetry.hpp"

namespace labmouse {

MazeSelection select_mazes(std::vector<NamedMaze> mazes, const World& world) {
  std::stable_sort(mazes.begin(), mazes.end(), [](const NamedMaze& a, const NamedMaze& b) { return a.name < b.name; });
  MazeSelection selection;
  std::map<CanonicalWalls, std::string> first_of;
  for (NamedMaze& maze : mazes) {
    if (!world.facts(maze.maze).bound) {
      selection.routeless.push_back(maze.name);
      continue;
    }
    const auto [first, is_new] = first_of.try_emplace(canonical_walls(maze.maze), maze.name);
    if (is_new)
      selection.mazes.push_back(std::move(maze));
    else
      selection.duplicates.push_back({maze.name, first->second});
  }
  return selection;
}

std::vector<int> deal_folds(const std::vector<std::string>& names, int folds, std::uint64_t seed) {
  const auto key = [&](std::size_t i) {
    const std::string_view name = names[i], file = name.substr(name.rfind('/') + 1);
    return std::tuple(seed_for(seed, file), file, name);
  };
  std::vector<std::size_t> shuffled(names.size());
  std::iota(shuffled.begin(), shuffled.end(), std::size_t{0});
  std::stable_sort(shuffled.begin(), shuffled.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::vector<int> fold_of(names.size());
  for (std::size_t i = 0; i < shuffled.size(); ++i)
    fold_of[shuffled[i]] = static_cast<int>(i % static_cast<std::size_t>(folds));
  return fold_of;
}

}  // namespace labmouse
