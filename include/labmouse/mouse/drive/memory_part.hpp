// The parts of the memory of a strategy's fields.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace labmouse {

/// One part, by its purpose.
struct MemoryPart {
  std::string_view name;
  std::size_t bytes = 0;
};

/// Parts by name: `labels` are times by node, `lattice` the maze in the form for route searches, `bounds` the least
/// times from the start, `waiting` the queue of nodes, `ways` the field of a search, `runs` the costs of runs, `other`
/// the rest.
using MemoryLayout = std::vector<MemoryPart>;

}  // namespace labmouse
