// What the memory of a strategy's fields is spent on.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace labmouse {

struct MemoryPart {
  std::string_view name;
  std::size_t bytes = 0;
};

/// `labels` are times by node, `lattice` the maze as routes see it, `bounds` the least times from the start, `waiting`
/// the nodes whose time has not come yet, `ways` the field of a search, `other` the rest.
using MemoryLayout = std::vector<MemoryPart>;

}  // namespace labmouse
