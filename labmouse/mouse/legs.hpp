// Two paths between the same cells, and the better legs of both.
#pragma once

#include <vector>

#include "labmouse/grid/cell.hpp"

namespace labmouse {

/// Cells, each a neighbour of the one before it.
using Path = std::vector<Cell>;

/// Writes the path that takes, from each crossing of the two to the next, the shorter leg, and the first path's where
/// both are equally long. Both begin in one cell and end in one cell. A crossing is a cell of both that lies behind the
/// last crossing on both. The result is not longer than the first path, so that much memory is enough.
void join_legs(const Path& first, const Path& second, Path& joined);

}  // namespace labmouse
