#include "labmouse/mouse/drive/search.hpp"

namespace labmouse::drive {

int bucket_shift(const DriveTables& tables) {
  return static_cast<int>(std::bit_width(static_cast<std::uint32_t>(tables.shortest_turn())));
}

}  // namespace labmouse::drive
