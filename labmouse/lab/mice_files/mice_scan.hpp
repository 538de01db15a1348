// A folder of robots as a mice file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace labmouse {

/// A robot that was found, or why there is none in its folder.
struct FoundMouse {
  std::string name;         ///< that of its folder, or of its file without the ending
  std::string kind;         ///< "capstone", "external mouse" or "mms"; empty where nothing was found
  std::string file;         ///< seen from the folder that was searched
  std::string interpreter;  ///< likewise, or a program of PATH; empty: the usual one, or none
  std::string remark;       ///< for people, on one line
  bool can_start = true;    ///< false where its interpreter is missing
};

/// Looks for one robot in each subfolder and for those that lie in the folder itself, by what stands in the files:
/// nothing is started. In the order of the names. `old_python` is the Python 2 of this machine; empty where it has
/// none.
std::vector<FoundMouse> scan_for_mice(const std::filesystem::path& folder, const std::string& old_python);

/// These as the text of a mice file.
std::string mice_file_text(const std::vector<FoundMouse>& mice);

}  // namespace labmouse
