// Numbers and strings in nested lists, as C, Python, JSON, NumPy and others write them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/maze/formats/problem_list.hpp"

namespace labmouse::formats {

/// A number, a string or a list of these, and where it stands.
struct ListItem {
  enum class Kind : std::uint8_t {
    number,
    string,
    word,  ///< such as WALL_NORTH
    list,
  };

  Kind kind = Kind::list;
  unsigned number = 0;
  std::string_view text = {};  ///< of a string, without its quotes, or of a word
  std::string_view key = {};   ///< in JSON, where it has one; otherwise empty
  std::vector<ListItem> items = {};
  int line = 0;
  int column = 0;
};

/// Reads the longest list of the text, the first of equals. Skips declarations and comments around it. `true` and
/// `false` are 1 and 0. Empty if there is no list; `problems` has the reason.
/// @param equal Gets the number of further lists of the same length.
std::optional<ListItem> read_lists(std::string_view content, ProblemList& problems, int& equal);

}  // namespace labmouse::formats
