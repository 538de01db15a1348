#include "labmouse/mouse/drive/edge_heap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "labmouse/chance/rng.hpp"

namespace labmouse {
namespace {

/// Beside a list that is searched through.
TEST(EdgeHeap, GivesBackTheFirstWhateverIsMovedAndTakenOut) {
  constexpr std::size_t edges = 40;
  Rng rng(41);
  for (int round = 0; round < 50; ++round) {
    std::vector<DriveTime> times(edges, no_time);
    std::vector<std::uint16_t> heap_room(edges), places(edges);
    EdgeHeap heap(heap_room.data(), places.data(), times.data());
    heap.clear(edges);
    std::vector<std::size_t> waiting;
    for (int step = 0; step < 200; ++step) {
      const auto edge = static_cast<std::size_t>(rng.below(edges));
      const auto place = std::find(waiting.begin(), waiting.end(), edge);
      ASSERT_EQ(heap.contains(edge), place != waiting.end());
      if (rng.chance(1, 2)) {
        // In, or forward.
        times[edge] = place == waiting.end() ? rng.below(1000) : times[edge] - rng.below(100);
        heap.reach(edge);
        if (place == waiting.end()) waiting.push_back(edge);
      } else {
        heap.remove(edge);
        if (place != waiting.end()) waiting.erase(place);
      }
      ASSERT_EQ(heap.empty(), waiting.empty());
      if (waiting.empty()) continue;
      const auto least = [&] {
        return std::min_element(waiting.begin(), waiting.end(),
                                [&](std::size_t a, std::size_t b) { return times[a] < times[b]; });
      };
      ASSERT_EQ(times[heap.first()], times[*least()]);
      if (!rng.chance(1, 5)) continue;
      const std::size_t taken = heap.take();
      ASSERT_EQ(times[taken], times[*least()]);
      waiting.erase(std::find(waiting.begin(), waiting.end(), taken));
    }
  }
}

}  // namespace
}  // namespace labmouse
