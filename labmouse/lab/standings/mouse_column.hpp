// The mice of a race as tables call them.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "labmouse/lab/mice/mouse_names.hpp"
#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// The mice as tables call them, in a column.
struct MouseColumn {
  std::vector<std::string> of;  ///< by their positions in the race
  std::size_t width = 5;

  explicit MouseColumn(const Race& race) {
    std::vector<std::string> specs;
    for (const Contestant& mouse : race.mice) specs.push_back(mouse.name);
    of = mouse_names(specs);
    for (std::size_t mouse = 0; mouse < of.size(); ++mouse) {
      if (race.mice[mouse].reference) of[mouse] += " *";
      width = std::max(width, of[mouse].size());
    }
  }
};

}  // namespace labmouse
