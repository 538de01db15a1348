#include "labmouse/lab/mms_folder.hpp"

#include <fmt/format.h>

#include "labmouse/lab/file_names.hpp"
#include "labmouse/lab/files.hpp"

namespace labmouse {

MmsRaceFolder::MmsRaceFolder(std::string folder, const MmsRace& race) : folder_(std::move(folder)) {
  std::vector<std::string> mice, mazes;
  for (const MmsMouse& mouse : race.mice) mice.push_back(mouse.name);
  for (const NamedMaze& maze : race.mazes) mazes.push_back(stem_of(maze.name));
  mouse_names_ = file_names(mice);
  maze_names_ = file_names(mazes);
}

std::string MmsRaceFolder::save(const MmsResult& result, const std::string& record) const {
  const std::string path = fmt::format("{}/{}/{}.jsonl", folder_, mouse_names_[result.mouse], maze_names_[result.maze]);
  const auto error = write_file(path, record);
  return error.empty() ? "" : fmt::format("{}: error: {}", path, error);
}

}  // namespace labmouse
