// Where edges are found: of shares as they would be, and of beams that pass walls and posts.
#include "labmouse/controller/edge_finder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>

#include "labmouse/body/beams.hpp"
#include "labmouse/controller/view.hpp"
#include "labmouse/hardware/beam.hpp"
#include "tests/controller/robots.hpp"

namespace labmouse {
namespace {

constexpr double reach = 18.0, half = 3.0, cell = 90.0;

double below(double number) { return std::erfc(-number / std::sqrt(2.0)) / 2.0; }
/// The share of a wall that a spot of 5 mm sees at a place behind the line, where a wall ends, begins, or a post
/// stands.
double falls(double behind) { return below((half - behind) / 5.0); }
double rises(double behind) { return 1.0 - below((-half - behind) / 5.0); }
double post(double behind) { return below((half - behind) / 5.0) - below((-half - behind) / 5.0); }

/// What a mouse finds that takes its place for so many mm less than it is.
std::optional<SeenEdge> found(const std::function<double(double)>& share, double off = 0.0, double step = 0.33,
                              double from = -40.0) {
  EdgeFinder finder(reach, half);
  for (double believed = from; believed < 40.0; believed += step)
    if (const auto edge = finder.pass(1, believed, share(believed + off))) return edge;
  return std::nullopt;
}

TEST(EdgeFinder, FindsWhatStandsThereAndHowFarOffItIs) {
  for (const double off : {-6.0, -2.0, 0.0, 3.0, 6.0}) {
    const auto end = found(falls, off), begin = found(rises, off), lone = found(post, off);
    ASSERT_TRUE(end && begin && lone) << off;
    EXPECT_EQ(end->edge, Edge::falls);
    EXPECT_EQ(begin->edge, Edge::rises);
    EXPECT_EQ(lone->edge, Edge::post);
    EXPECT_NEAR(end->behind, -off, 0.2);
    EXPECT_NEAR(begin->behind, -off, 0.2);
    EXPECT_NEAR(lone->behind, -off, 0.4);
  }
}

TEST(EdgeFinder, FindsThemAtAllSpeeds) {
  for (const double step : {0.05, 0.33, 1.5, 3.0}) {
    ASSERT_TRUE(found(falls, 2.0, step));
    EXPECT_NEAR(found(falls, 2.0, step)->behind, -2.0, 0.2 + step / 10.0) << step;
    EXPECT_NEAR(found(rises, 2.0, step)->behind, -2.0, 0.2 + step / 10.0) << step;
  }
}

TEST(EdgeFinder, FindsNoneAlongAWallOrWithoutOne) {
  EXPECT_FALSE(found([](double) { return 1.0; }));
  EXPECT_FALSE(found([](double) { return 0.0; }));
}

TEST(EdgeFinder, FindsNoneWhereItComesInTheMiddle) { EXPECT_FALSE(found(falls, 0.0, 0.33, -10.0)); }

TEST(EdgeFinder, FindsNoneWhereTheMouseGoesBackOrJumps) {
  EdgeFinder finder(reach, half);
  double behind = -20.0;
  for (; behind < 0.0; behind += 0.5) EXPECT_FALSE(finder.pass(1, behind, falls(behind)));
  EXPECT_FALSE(finder.pass(1, behind - 2.0, falls(behind)));
  for (; behind < 30.0; behind += 0.5) EXPECT_FALSE(finder.pass(1, behind, falls(behind)));
}

TEST(EdgeFinder, FindsNoneWhereItForgetsOnTheWay) {
  EdgeFinder finder(reach, half);
  for (double behind = -20.0; behind < 0.0; behind += 0.5) EXPECT_FALSE(finder.pass(1, behind, falls(behind)));
  finder.forget();
  for (double behind = 0.0; behind < 30.0; behind += 0.5) EXPECT_FALSE(finder.pass(1, behind, falls(behind)));
}

}  // namespace
}  // namespace labmouse
