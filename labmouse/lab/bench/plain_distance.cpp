#include "labmouse/lab/bench/plain_distance.hpp"

#include <algorithm>
#include <queue>

#include "labmouse/mouse/distance.hpp"

namespace labmouse {

std::vector<int> plain_distances(Size size, const Motion& motion, const WallSet& passages, const CellSet& from) {
  std::vector<int> distances(static_cast<std::size_t>(size.area()), unreachable);
  std::priority_queue<std::pair<int, int>, std::vector<std::pair<int, int>>, std::greater<>> queue;
  const auto reach = [&](Cell cell, int distance) {
    int& known = distances[static_cast<std::size_t>(size.index(cell))];
    if (distance >= known) return;
    known = distance;
    queue.emplace(distance, size.index(cell));
  };
  from.for_each([&](Cell cell) { reach(cell, 0); });
  while (!queue.empty()) {
    const auto [distance, index] = queue.top();
    queue.pop();
    if (distance > distances[static_cast<std::size_t>(index)]) continue;
    for (const Heading heading : all_headings) {
      Cell cell = size.cell_at(index);
      for (int cells = 1; cells <= motion.longest && passages.contains(wall_at(cell, heading)); ++cells) {
        cell = neighbour(cell, heading);
        reach(cell, distance + motion.cost[static_cast<unsigned>(cells)]);
      }
    }
  }
  return distances;
}

RingSearch::RingSearch(Size size, int longest, const WallSet& passages)
    : size_(size),
      longest_(longest),
      open_(static_cast<std::size_t>(size.area())),
      distances_(static_cast<std::size_t>(size.area())),
      queue_(static_cast<std::size_t>(size.area())) {
  for (int index = 0; index < size.area(); ++index)
    for (const Heading heading : all_headings)
      if (passages.contains(wall_at(size.cell_at(index), heading)))
        open_[static_cast<std::size_t>(index)] |= static_cast<unsigned char>(1U << static_cast<unsigned>(heading));
}

const std::vector<int>& RingSearch::fill(const CellSet& from) {
  std::fill(distances_.begin(), distances_.end(), unreachable);
  std::size_t head = 0, tail = 0;
  from.for_each([&](Cell cell) {
    distances_[static_cast<std::size_t>(size_.index(cell))] = 0;
    queue_[tail++] = size_.index(cell);
  });
  const int stride[4] = {size_.width, 1, -size_.width, -1};
  while (head < tail) {
    const int from_index = queue_[head++];
    const int distance = distances_[static_cast<std::size_t>(from_index)] + 1;
    for (unsigned side = 0; side < 4; ++side) {
      int index = from_index;
      for (int cells = 0; cells < longest_ && (open_[static_cast<std::size_t>(index)] >> side & 1U) != 0; ++cells) {
        index += stride[side];
        int& known = distances_[static_cast<std::size_t>(index)];
        if (known <= distance) continue;
        known = distance;
        queue_[tail++] = index;
      }
    }
  }
  return distances_;
}

}  // namespace labmouse
