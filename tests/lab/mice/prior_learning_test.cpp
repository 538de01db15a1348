#include "labmouse/lab/mice/prior_learning.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "labmouse/chance/rng.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/maze/symmetry.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/lab/races/race_fixture.hpp"

namespace labmouse {
namespace {

/// A context from its digits, that of neighbour 0 first.
int context(std::string_view digits) {
  int number = 0;
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit) number = 3 * number + (*digit - '0');
  return number;
}

WallCount& at(PriorCounts& counts, std::string_view digits) {
  return counts.walls[static_cast<unsigned>(folded_context(context(digits)))];
}

StepRecord step(const Maze& maze, Pose pose, Run run = Run::search_run) {
  StepRecord record;
  record.run = run;
  record.pose = pose;
  record.sighting = look(maze, pose);
  return record;
}

/// The counts of a search run that stands in these poses.
PriorCounts counts_in(const Maze& maze, std::initializer_list<Pose> poses) {
  RunRecord record;
  for (const Pose pose : poses) record.steps.push_back(step(maze, pose));
  PriorCounts counts;
  counts.add(maze, record);
  return counts;
}

/// Of the four walls, the one east of (0,1) is closed.
TEST(Counts, OfATinyMazeAreThoseByHand) {
  const Maze maze = test::hook().maze;
  PriorCounts expected;
  // From the start one sees the walls north and east of it; the other two meet both, each at one post.
  at(expected, "11022222") = {1, 1};
  EXPECT_EQ(counts_in(maze, {{{0, 0}, Heading::north}}), expected);
  // The closed one, seen from (0,1), changes the surroundings of the last.
  at(expected, "11222222") = {1, 0};
  EXPECT_EQ(counts_in(maze, {{{0, 0}, Heading::north}, {{0, 1}, Heading::north}}), expected);
  // Nothing new, nothing to count.
  EXPECT_EQ(counts_in(maze, {{{0, 0}, Heading::north}, {{0, 1}, Heading::north}, {{0, 1}, Heading::west}}), expected);
}

TEST(Counts, AreNotOfTheSpeedRun) {
  const Maze maze = test::hook().maze;
  RunRecord record;
  record.steps = {step(maze, {{0, 0}, Heading::north}), step(maze, {{0, 0}, Heading::north}, Run::speed),
                  step(maze, {{0, 1}, Heading::north}, Run::speed)};
  PriorCounts counts;
  counts.add(maze, record);
  EXPECT_EQ(counts, counts_in(maze, {{{0, 0}, Heading::north}}));
}

/// No wall but one on the rim of the goal room, east of (2,2).
Maze room() {
  MazeDraft draft({4, 4}, MazeDraft::Inside::open);
  draft.close({2, 2}, Heading::east);
  return Maze(draft);
}

std::int64_t sum(const WallCount& count) { return count.open + count.closed; }

template <class Counts>
std::int64_t sum_of(const Counts& counts) {
  std::int64_t walls = 0;
  for (const WallCount& count : counts) walls += sum(count);
  return walls;
}

TEST(Counts, OfTheRimAreByWhatWasSeenOfIt) {
  PriorCounts counts = counts_in(room(), {{{0, 0}, Heading::north}});
  EXPECT_EQ(counts.rim[0], (WallCount{7, 1}));
  counts = counts_in(room(), {{{0, 0}, Heading::north}, {{0, 1}, Heading::east}});
  EXPECT_EQ(counts.rim[0], (WallCount{7, 1}));
  // Two open ones were seen at once, through the room.
  EXPECT_EQ(counts.rim[static_cast<unsigned>(rim_context(2, 0))], (WallCount{5, 1}));
  counts = counts_in(room(), {{{3, 2}, Heading::north}, {{3, 1}, Heading::west}});
  EXPECT_EQ(counts.rim[static_cast<unsigned>(rim_context(0, 1))], (WallCount{7, 0}));
  EXPECT_EQ(counts.rim[static_cast<unsigned>(rim_context(2, 1))], (WallCount{5, 0}));
  EXPECT_EQ(sum_of(counts.rim), 7 + 5);
}

TEST(Counts, LeaveOutWallsBetweenGoalCells) {
  // 24 inner walls: 4 inside, 8 on the rim, 6 seen from the corner.
  EXPECT_EQ(sum_of(counts_in(room(), {{{0, 0}, Heading::north}}).walls), 24 - 4 - 8 - 6);
}

TEST(Counts, HaveARimOfSquareRoomsOnly) {
  CellSet row;
  for (int x = 0; x < 4; ++x) row.insert({x, 3});
  const PriorCounts counts = counts_in(room().with_goals(row), {{{0, 0}, Heading::north}});
  EXPECT_EQ(sum_of(counts.rim), 0);
  EXPECT_EQ(sum_of(counts.walls), 24 - 3 - 6);
}

/// The same contest in the maze turned and mirrored.
RunRecord transformed(RunRecord record, Size size, Symmetry symmetry) {
  for (StepRecord& step : record.steps) {
    step.pose.cell = transformed(step.pose.cell, size, symmetry);
    step.pose.heading = transformed(step.pose.heading, symmetry);
    if (symmetry.mirrored) std::swap(step.sighting.left, step.sighting.right);
  }
  return record;
}

TEST(Counts, OfMirrorImagesAreAlike) {
  for (const Size size : {Size{8, 8}, Size{9, 6}}) {
    const Maze maze = prim_generator.make({size, 5, 100});
    const BuiltinMouse& mouse = flood_explore_mouse;
    const auto strategy = mouse.make(brief(maze, {}, 1), Settings(mouse.parameters));
    const RunRecord record = run(maze, {}, *strategy);
    PriorCounts counts;
    counts.add(maze, record);
    EXPECT_GT(sum_of(counts.walls), 100);
    for (const Symmetry symmetry : all_symmetries) {
      PriorCounts image;
      image.add(transformed(maze, symmetry), transformed(record, size, symmetry));
      EXPECT_EQ(image, counts);
    }
  }
}

TEST(APrior, OfNothingTakesEveryWallForAsLikelyOpenAsClosed) {
  const WallPrior prior = prior_of({});
  EXPECT_THAT(prior.walls, testing::Each(22));
  EXPECT_THAT(prior.rim, testing::Each(22));
  EXPECT_EQ(fit_of({}).walls, 0);
}

int reluctance(const WallPrior& prior, std::string_view digits) {
  return prior.walls[static_cast<unsigned>(context(digits))];
}

TEST(APrior, LeansOnWiderClassesWhereLittleWasCounted) {
  PriorCounts counts;
  at(counts, "12000012") = {0, 20};
  const WallPrior prior = prior_of(counts);
  const double all = 20.5 / 21, six = (20 + 10 * all) / 30, eight = (20 + 10 * six) / 30;
  const auto expected = [](double closed) { return std::lround(-32 * std::log(1 - closed)); };
  EXPECT_EQ(reluctance(prior, "12000012"), expected(eight));
  EXPECT_EQ(reluctance(prior, "00012012"), expected(eight)) << "a mirror image";
  EXPECT_EQ(reluctance(prior, "12000000"), expected(six)) << "other parallel walls";
  EXPECT_EQ(reluctance(prior, "11000012"), expected(all));
  EXPECT_THAT(prior.rim, testing::Each(expected(all)));
  EXPECT_LT(expected(all), expected(six));
  EXPECT_LT(expected(six), expected(eight));
}

TEST(APrior, OfARimIsByItsOwnCounts) {
  PriorCounts counts;
  counts.rim[9] = {0, 2};
  const WallPrior prior = prior_of(counts);
  EXPECT_EQ(prior.rim[9], std::lround(-32 * std::log(1 - 0.75)));
  EXPECT_EQ(prior.rim[8], 22);
}

TEST(APrior, RoundsAsTheLogarithmDoes) {
  Rng rng(3);
  for (int trial = 0; trial < 20; ++trial) {
    PriorCounts counts;
    for (WallCount& count : counts.rim) count = {rng.below(1000), rng.below(100'000)};
    const WallPrior prior = prior_of(counts);
    for (unsigned i = 0; i < counts.rim.size(); ++i) {
      const WallCount& count = counts.rim[i];
      const double closed = (static_cast<double>(count.closed) + 1.0) / (static_cast<double>(sum(count)) + 2.0);
      EXPECT_EQ(prior.rim[i], std::lround(-32 * std::log(std::max(0.001, 1 - closed))));
    }
  }
}

TEST(APrior, IsNeverSurerThanOneInAThousand) {
  PriorCounts counts;
  counts.rim[0] = {0, 1'000'000};
  counts.rim[1] = {1'000'000, 0};
  EXPECT_EQ(prior_of(counts).rim[0], 221);
  EXPECT_EQ(prior_of(counts).rim[1], 0);
}

TEST(TheFit, ComparesWithTheCommonShare) {
  PriorCounts counts;
  counts.rim[0] = {998, 0};
  counts.rim[1] = {0, 998};
  const PriorFit fit = fit_of(counts);
  EXPECT_EQ(fit.walls, 2 * 998);
  EXPECT_DOUBLE_EQ(fit.entropy, std::log(2.0));
  EXPECT_DOUBLE_EQ(fit.log_loss, -std::log(999.0 / 1000.0));
}

TEST(LearnPrior, DependsNotOnTheOrder) {
  const Maze one = test::loop().maze, two = test::hook().maze;
  const std::vector<const Maze*> forwards = {&one, &two}, backwards = {&two, &one}, alone = {&one};
  EXPECT_EQ(learn_prior(forwards, {}), learn_prior(backwards, {}));
  EXPECT_NE(learn_prior(forwards, {}), learn_prior(alone, {}));
}

TEST(LearnPrior, ExploresNothingOnceItIsStopped) {
  const Maze maze = test::loop().maze;
  const std::vector<const Maze*> mazes = {&maze};
  const std::atomic<bool> stop = true;
  EXPECT_EQ(learn_prior(mazes, {}, &stop), learn_prior({}, {}));
  EXPECT_NE(learn_prior(mazes, {}), learn_prior({}, {}));
}

}  // namespace
}  // namespace labmouse
