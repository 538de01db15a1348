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

/// The longest list of the text with all that is in it; what stands around it (declarations, comments) is skipped.
/// `true` and `false` are 1 and 0. Nothing where there is no list, with the reason in `problems`.
std::optional<ListItem> read_lists(std::string_view content, ProblemList& problems);

}  // namespace labmouse::formats
