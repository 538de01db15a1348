#include "labmouse/lab/page/request.hpp"

#include "labmouse/lab/replays/maze_data.hpp"
#include "labmouse/mouse/motion.hpp"

namespace labmouse {

NamedMaze PageRequest::maze(const char* key) {
  static const ReadJson nothing;
  if (!has(key)) reject(fmt::format("'{}' is missing", key));
  return maze_at(has(key) ? request_[key] : nothing, key);
}

NamedMaze PageRequest::maze_at(const ReadJson& json, const std::string& path) {
  MazeDataResult read = read_maze_data(json, path);
  if (read.maze) return std::move(*read.maze);
  reject(read.error);
  return {"", Maze(MazeDraft({1, 1}, MazeDraft::Inside::closed))};
}

std::uint64_t PageRequest::seed() {
  if (has("seed") && request_["seed"].is_number_unsigned()) return request_["seed"].get<std::uint64_t>();
  reject("'seed' is not a number from 0 to 2^64 - 1");
  return 0;
}

Rules PageRequest::rules() {
  Rules rules;
  if (has("budget")) rules.budget = whole("budget", 1, most_page_steps);
  if (has("search_factor")) rules.search_factor = whole("search_factor", 1, most_page_steps);
  if (has("stride")) rules.stride = whole("stride", 1, Motion::max_longest);
  return rules;
}

}  // namespace labmouse
