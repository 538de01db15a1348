// Merging of two paths between the same cells.
#pragma once

#include <vector>

#include "labmouse/grid/cell.hpp"

namespace labmouse {

/// Cells, each a neighbour of the one before it.
using Path = std::vector<Cell>;

/// Merges two paths with the same first and last cell. From each crossing of the two to the next it takes the shorter
/// leg, that of the first path on a tie. A crossing is a cell of both paths that comes after the previous crossing on
/// both. The result is not longer than the first path, which bounds its memory.
void join_legs(const Path& first, const Path& second, Path& joined);

}  // namespace labmouse
