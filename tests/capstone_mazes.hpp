// The three test mazes that the reports speak of. The first is printed in one of them and comes with the project; the
// others are looked for in a folder of mazes: $LABMOUSE_MAZES, or one beside the checkout.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include "labmouse/maze/formats/format.hpp"

namespace labmouse::test {

inline std::optional<Maze> maze_in_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return read_maze(std::string(std::istreambuf_iterator<char>(file), {})).maze;
}

inline std::filesystem::path folder_of_mazes() {
  const char* folder = std::getenv("LABMOUSE_MAZES");
  return folder != nullptr ? folder : LABMOUSE_SOURCE_DIR "/../shared/mazes";
}

/// Test maze 1, 2 or 3; nothing where its file is absent.
inline std::optional<Maze> capstone_maze(int number) {
  if (number == 1) return maze_in_file(LABMOUSE_SOURCE_DIR "/mazes/capstone-1.txt");
  return maze_in_file(folder_of_mazes() / "capstone" / ("test_maze_0" + std::to_string(number) + ".txt"));
}

}  // namespace labmouse::test
