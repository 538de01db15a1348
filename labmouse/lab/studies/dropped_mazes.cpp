#include "labmouse/lab/studies/dropped_mazes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

std::string listed(const std::vector<std::string>& names, std::string_view elsewhere) {
  constexpr std::size_t most = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i) text += "  " + shown(names[i]) + "\n";
  if (names.size() > most) text += fmt::format("  ... and {} more{}\n", names.size() - most, elsewhere);
  return text;
}

}  // namespace

std::string left_out_notes(const MazeSelection& selection, std::string_view elsewhere) {
  std::string notes;
  std::vector<std::string> duplicates;
  for (const Duplicate& duplicate : selection.duplicates)
    duplicates.push_back(duplicate.name + " = " + duplicate.same_as);
  if (!duplicates.empty())
    notes += fmt::format("{} left out (the same walls, possibly rotated or mirrored):\n{}",
                         counted(std::ssize(duplicates), "duplicate", "duplicates"), listed(duplicates, elsewhere));
  const std::vector<std::string>& routeless = selection.routeless;
  if (!routeless.empty())
    notes += fmt::format("{} left out because the goal cannot be reached:\n{}",
                         counted(std::ssize(routeless), "maze", "mazes"), listed(routeless, elsewhere));
  return notes;
}

}  // namespace labmouse
