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
  /// The mouse's own folder; empty where it has none, because it would be the whole file system.
  std::string folder;
  /// Where the program starts; the own folder, or somewhere else that stays empty.
  std::string directory;
  /// Folders and files that it may read: the system's, those of its interpreter, and those that its command names.
  /// Sorted, so that each stands behind the folders that hold it; none lies in the own folder.
  std::vector<std::string> visible;
  /// Links on the way to them, and where each leads.
  std::vector<std::pair<std::string, std::string>> links;
  /// What must not be seen of these: our own program, libraries and Python package, which hold the built-in mazes.
  std::vector<std::string> hidden;
};

/// Whether a path is that folder or lies in it; false if the folder is empty.
bool lies_in(std::string_view path, std::string_view folder);

/// What a mouse that is started so needs. `program`: the path of its first word, as of program_path.
Surroundings surroundings_of(const Launch& launch, const std::string& program);

/// The folder of a mouse: its directory, where it owns that; otherwise that of the file that its command names, where
/// it names one that is no part of the system; or else the directory all the same.
std::string folder_of(const Launch& launch, const std::string& program);

/// Of these sorted paths those that the mouse could see.
std::vector<std::string> seen_of(const Surroundings& around, const std::vector<std::string>& paths);

}  // namespace labmouse
