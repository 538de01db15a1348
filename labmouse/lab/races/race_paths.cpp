#include "labmouse/lab/races/race_paths.hpp"

#include <fmt/format.h>

#include "labmouse/lab/system/file_names.hpp"

namespace labmouse {

RacePaths::RacePaths(std::string folder, const std::vector<std::string>& mice, const std::vector<std::string>& mazes,
                     bool numbers_runs)
    : folder_(std::move(folder)), mouse_names_(file_names(mice)), numbers_runs_(numbers_runs) {
  std::vector<std::string> stems;
  for (const std::string& maze : mazes) stems.push_back(stem_of(maze));
  maze_names_ = file_names(stems);
}

std::string RacePaths::record(std::size_t mouse, std::size_t maze, int run) const {
  return stem(mouse, maze) + (numbers_runs_ ? fmt::format("-{}.jsonl", run + 1) : ".jsonl");
}

std::string RacePaths::picture(std::size_t mouse, std::size_t maze) const { return stem(mouse, maze) + ".svg"; }

std::string RacePaths::stem(std::size_t mouse, std::size_t maze) const {
  return fmt::format("{}/{}/{}", folder_, mouse_names_[mouse], maze_names_[maze]);
}

}  // namespace labmouse
