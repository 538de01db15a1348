// Numbers of the edges by which cells are entered, one for each heading: 4 * cell + heading. The side of
// the cell in that heading has the same number.
#pragma once

#include <array>
#include <cstddef>

#include "labmouse/grid/cell.hpp"

namespace labmouse {

/// What to add to the number of an edge for that of the next edge ahead, by heading. Negative differences wrap around,
/// as unsigned numbers do.
constexpr std::array<std::size_t, 4> edges_ahead(Size size) {
  const auto row = static_cast<std::size_t>(4 * size.width);
  return {row, 4, std::size_t{0} - row, std::size_t{0} - 4};
}

/// The edge of the same cell after a turn by so many quarters to the right.
constexpr std::size_t turned_edge(std::size_t edge, std::size_t quarters) {
  return (edge & ~std::size_t{3}) | ((edge + quarters) & 3U);
}
/// The edge of the same cell in the opposite heading.
constexpr std::size_t behind(std::size_t edge) { return edge ^ 2U; }

}  // namespace labmouse
