// Searches a folder for mice, and writes a mice file of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace labmouse {

/// A mouse that was found, or the reason why its folder has none.
struct FoundMouse {
  std::string name;         ///< the name of its folder, or of its file without the extension
  std::string kind;         ///< "capstone", "program", "controller" or "mms"; empty if nothing was found
  std::string file;         ///< path relative to the folder that was searched
  std::string interpreter;  ///< likewise, or a program in PATH; empty: the default one, or none
  std::string remark;       ///< for the user, one line
  bool can_start = true;    ///< false where its interpreter is missing
};

/// Searches for mice in the folder itself, and for one in each subfolder. It inspects the contents of files and starts
/// nothing. Sorted by name.
/// @param old_python Path of Python 2 on this machine; empty if there is none.
std::vector<FoundMouse> scan_for_mice(const std::filesystem::path& folder, const std::string& old_python);

/// The text of a mice file with these mice.
std::string mice_file_text(const std::vector<FoundMouse>& mice);

}  // namespace labmouse
