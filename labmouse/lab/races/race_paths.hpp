// Where a race leaves its files.
#pragma once

#include <string>
#include <vector>

namespace labmouse {

/// The names of mice or mazes.
template <class Things>
std::vector<std::string> names_of(const Things& things) {
  std::vector<std::string> names;
  for (const auto& thing : things) names.push_back(thing.name);
  return names;
}

/// The JSON of the race in its folder.
inline constexpr const char* results_file_name = "results.json";

/// The paths of one race: FOLDER/MOUSE/MAZE-RUN.jsonl for the record of each contest, or FOLDER/MOUSE/MAZE.jsonl in a
/// world where each mouse has but one in a maze, and FOLDER/MOUSE/MAZE.svg for a picture of the first. MAZE is the
/// file's name without folders and ending; where two mazes of a race share it, the later ones get a number.
class RacePaths {
 public:
  /// The names of all mice of one world and of all mazes, in the order of the race, which is that of the names.
  RacePaths(std::string folder, const std::vector<std::string>& mice, const std::vector<std::string>& mazes,
            bool numbers_runs = true);

  /// Mice and mazes are positions in the lists; runs count from 0.
  std::string record(std::size_t mouse, std::size_t maze, int run) const;
  std::string picture(std::size_t mouse, std::size_t maze) const;

 private:
  std::string stem(std::size_t mouse, std::size_t maze) const;

  std::string folder_;
  std::vector<std::string> mouse_names_;
  std::vector<std::string> maze_names_;
  bool numbers_runs_;
};

}  // namespace labmouse
