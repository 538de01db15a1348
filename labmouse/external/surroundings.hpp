// Which part of the file system an external mouse sees in its sandbox.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "labmouse/external/hidden_files.hpp"
#include "labmouse/external/launch.hpp"

namespace labmouse {

/// All paths are absolute.
struct Surroundings {
  /// The mouse's own folder; empty if that would be the whole file system.
  std::string folder;
  /// The working directory: the own folder, or another one, which appears empty.
  std::string directory;
  /// Folders and files that it may read: the system's, those of its interpreter, and those that its command names.
  /// Sorted, so that each follows its parent folders; none lies in the own folder.
  std::vector<std::string> visible;
  /// The folders among these that its command, PYTHONPATH or NODE_PATH names.
  std::vector<std::string> named;
  /// Links on the way to them, with their targets.
  std::vector<std::pair<std::string, std::string>> links;
  /// Parts of these that are hidden: the labmouse program, libraries and Python package, which contain the built-in
  /// mazes.
  std::vector<std::string> hidden;
};

/// Whether a path is that folder or lies in it; false if the folder is empty.
bool lies_in(std::string_view path, std::string_view folder);

/// The surroundings for a launch. `program`: the path of its first word, from program_path().
Surroundings surroundings_of(const Launch& launch, const std::string& program);

/// The folder of a mouse: its directory, if it owns that; otherwise the folder of the first file in its command that is
/// not part of the system; otherwise its directory.
std::string folder_of(const Launch& launch, const std::string& program);

/// The given paths that the mouse could see.
std::vector<std::string> seen_of(const Surroundings& around, const std::vector<std::string>& paths);

}  // namespace labmouse
