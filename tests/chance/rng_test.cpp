#include "labmouse/chance/rng.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace labmouse {
namespace {

TEST(Rng, ThrowsTheNumbersThatSplitMix64Publishes) {
  // The first outputs for seed 1234567, as other implementations print them.
  Rng rng(1234567);
  EXPECT_EQ(rng.bits(), 6457827717110365317U);
  EXPECT_EQ(rng.bits(), 3203168211198807973U);
  EXPECT_EQ(rng.bits(), 9817491932198370423U);
}

TEST(Rng, SidesStayWhatTheyWere) {
  Rng rng(1);
  std::vector<int> throws;
  for (int i = 0; i < 12; ++i) throws.push_back(rng.below(6));
  EXPECT_EQ(throws, (std::vector<int>{3, 4, 5, 2, 2, 4, 5, 3, 1, 4, 2, 3}));
}

TEST(Rng, EqualSeedsGiveEqualThrows) {
  Rng one(7), other(7);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(one.below(1000), other.below(1000));
}

TEST(Rng, EverySideComesUpEquallyOften) {
  for (const int sides : {2, 3, 6, 7, 100}) {
    Rng rng(42);
    std::vector<int> counts(static_cast<std::size_t>(sides));
    const int throws = 1000 * sides;
    for (int i = 0; i < throws; ++i) ++counts.at(static_cast<std::size_t>(rng.below(sides)));
    double chi_squared = 0.0;
    for (const int count : counts) chi_squared += (count - 1000.0) * (count - 1000.0) / 1000.0;
    // Five deviations above the mean of the distribution with sides - 1 degrees of freedom.
    EXPECT_LT(chi_squared, sides - 1 + 5 * std::sqrt(2.0 * (sides - 1))) << sides << " sides";
  }
}

TEST(Rng, NoSideGainsWhereTheSidesDoNotDivideTheBits) {
  // Of every eight numbers of 32 bits three fall to each of two sides and two to the third, unless it throws again.
  constexpr int sides = 0x6000'0000;
  Rng rng(3);
  int even = 0;
  for (int i = 0; i < 30'000; ++i) even += rng.below(sides) % 3 == 0 ? 1 : 0;
  EXPECT_NEAR(even, 10'000, 400);
}

TEST(Rng, OneSideIsCertain) {
  Rng rng(5);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(rng.below(1), 0);
}

TEST(Rng, ChanceKeepsItsShare) {
  Rng rng(11);
  int hits = 0;
  for (int i = 0; i < 10'000; ++i) hits += rng.chance(3, 10) ? 1 : 0;
  EXPECT_NEAR(hits, 3000, 250);
  EXPECT_FALSE(rng.chance(0, 10));
  EXPECT_TRUE(rng.chance(10, 10));
}

TEST(SeedFor, DependsOnSeedNameAndNumber) {
  std::set<std::uint64_t> seeds;
  for (const std::uint64_t seed : {0U, 1U, 2U})
    for (const std::string name : {"", "a", "b", "ab", "ba"})
      for (const std::uint64_t number : {0U, 1U, 2U}) seeds.insert(seed_for(seed, name, number));
  EXPECT_EQ(seeds.size(), 3U * 5U * 3U);
}

TEST(SeedFor, StaysWhatItWas) { EXPECT_EQ(seed_for(1, "capstone-1", 0), 4289499928268098154U); }

}  // namespace
}  // namespace labmouse
