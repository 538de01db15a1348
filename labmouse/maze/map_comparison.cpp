#include "labmouse/maze/map_comparison.hpp"

namespace labmouse {

std::optional<MapComparison> compare_maps(const Maze& map, const WallSet& unseen, const Maze& maze) {
  if (map.size() != maze.size()) return std::nullopt;
  MapComparison comparison{.false_walls = maze.open_walls(), .missed_walls = map.open_walls(), .unseen = unseen};
  comparison.false_walls -= map.open_walls();
  comparison.missed_walls -= maze.open_walls();
  comparison.missed_walls -= unseen;
  return comparison;
}

}  // namespace labmouse
