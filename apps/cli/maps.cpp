#include "maps.hpp"

#include <fmt/format.h>

#include <utility>

#include "labmouse/lab/text/printable.hpp"

namespace labmouse::cli {

ComparedMap compare_map(const std::string& path, const std::string& truth, const Places& places) {
  ComparedMap compared{.truth = find_maze(truth, places), .found = {}, .reading = {}};
  ReadResult read = load_map(path);
  if (!read.maze && !read.partial) throw UsageError(describe(path, read.problems.front()));
  const Maze& map = read.maze ? *read.maze : read.partial->known;
  auto found = compare_maps(map, read.partial ? read.partial->unseen : WallSet(), compared.truth.maze);
  if (!found) {
    const Size size = compared.truth.maze.size();
    throw UsageError(fmt::format("{}: error: the map has {}x{} cells, {} has {}x{}", path, map.size().width,
                                 map.size().height, shown(compared.truth.name), size.width, size.height));
  }
  compared.found = std::move(*found);
  compared.reading = std::move(read.reading);
  return compared;
}

}  // namespace labmouse::cli
