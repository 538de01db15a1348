#include "labmouse/mouse/drive/edge_buckets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "labmouse/chance/rng.hpp"

namespace labmouse {
namespace {

/// Beside a list that is searched through.
TEST(EdgeBuckets, GiveBackTheFirstUpToTheirWidthWhateverIsMovedAndTakenOut) {
  constexpr std::size_t edges = 40;
  constexpr DriveTime width = 8;
  Rng rng(41);
  for (int round = 0; round < 50; ++round) {
    std::vector<DriveTime> times(edges, no_time);
    std::vector<std::uint16_t> before(edges), next(edges);
    EdgeBuckets buckets(before.data(), next.data(), times.data());
    buckets.clear(edges, width);
    std::vector<std::size_t> waiting;
    for (int step = 0; step < 200; ++step) {
      const auto edge = static_cast<std::size_t>(rng.below(edges));
      const auto place = std::find(waiting.begin(), waiting.end(), edge);
      ASSERT_EQ(buckets.contains(edge), place != waiting.end());
      if (rng.chance(1, 2)) {
        // The ring is shorter than the range of these times.
        times[edge] = rng.below(4000);
        buckets.put(edge);
        if (place == waiting.end()) waiting.push_back(edge);
      } else {
        buckets.remove(edge);
        if (place != waiting.end()) waiting.erase(place);
      }
      ASSERT_EQ(buckets.find(no_time), !waiting.empty());
      if (waiting.empty()) continue;
      const DriveTime least = times[*std::min_element(
          waiting.begin(), waiting.end(), [&](std::size_t a, std::size_t b) { return times[a] < times[b]; })];
      ASSERT_TRUE(buckets.find(least));
      ASSERT_FALSE(least >= width && buckets.find(least - width));
      if (!rng.chance(1, 5)) continue;
      ASSERT_TRUE(buckets.find(least));
      const std::size_t taken = buckets.take();
      ASSERT_EQ(times[taken] / width, least / width);
      waiting.erase(std::find(waiting.begin(), waiting.end(), taken));
    }
  }
}

}  // namespace
}  // namespace labmouse
