// Mazes that do not come with the project: a folder of maze files, $LABMOUSE_MAZES or one beside the checkout. Among
// them are the test mazes 2 and 3 that the reports speak of; the first is printed in one of them and comes with the
// project.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "labmouse/maze/formats/format.hpp"

namespace labmouse::test {

/// What a file holds; nothing where there is none.
inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline std::optional<Maze> maze_in_file(const std::filesystem::path& path) { return read_maze(text_of(path)).maze; }

inline std::filesystem::path folder_of_mazes() {
  const char* folder = std::getenv("LABMOUSE_MAZES");
  return folder != nullptr ? folder : LABMOUSE_SOURCE_DIR "/../shared/mazes";
}

/// All maze files of the folder, sorted; none where there is no folder.
inline std::vector<std::filesystem::path> maze_files() {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_of_mazes(), error))
    if (entry.is_regular_file() && entry.path().filename() != "README.md") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// Test maze 1, 2 or 3; nothing where its file is absent.
inline std::optional<Maze> capstone_maze(int number) {
  if (number == 1) return maze_in_file(LABMOUSE_SOURCE_DIR "/mazes/capstone-1.txt");
  return maze_in_file(folder_of_mazes() / "capstone" / ("test_maze_0" + std::to_string(number) + ".txt"));
}

}  // namespace labmouse::test
