// Strategies bear any readings: 10,000 contests in small mazes.
#include "tests/lab/wild_contest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/slowness.hpp"

namespace labmouse {
namespace {

class AMind : public ::testing::TestWithParam<std::size_t> {};

std::string name_of_strategy(const ::testing::TestParamInfo<std::size_t>& tested) {
  std::string name(test::wild_strategies[tested.param]);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

TEST_P(AMind, BearsWhateverIsRead) {
  int turned = 0;
  for (std::uint64_t seed = 1; seed <= test::fewer(2000U); ++seed) {
    test::WildContest contest;
    contest.seed = seed;
    contest.strategy = GetParam();
    contest.side = 3 + static_cast<int>(seed % 5);
    contest.loops = static_cast<int>(seed % 4) * 100;
    contest.wild = 0.25 * static_cast<double>(1 + seed % 4);
    contest.crash = seed % 3 == 0 ? 0.02 : 0.0;
    const PhysicalRecord record = test::held(contest);
    EXPECT_TRUE(test::came_to_its_end(record))
        << seed << ": " << name_of(record.drive.outcome) << ", reason " << static_cast<int>(record.drive.reason);
    EXPECT_LT(record.drive.decisions, test::most_decisions) << seed;
    turned += record.contradictions > 0 ? 1 : 0;
  }
  EXPECT_GT(turned, test::fewer(250));
}

INSTANTIATE_TEST_SUITE_P(All, AMind, ::testing::Range(std::size_t{0}, test::wild_strategies.size()), name_of_strategy);

}  // namespace
}  // namespace labmouse
