#include "labmouse/lab/bounds/mms_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <tuple>

#include "labmouse/chance/rng.hpp"
#include "labmouse/external/mms/host.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "tests/capstone_mazes.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

Maze open_room(int width, int height) { return Maze(MazeDraft({width, height}, MazeDraft::Inside::open)); }

MmsHost played(const Maze& maze, const std::vector<std::string>& commands) {
  MmsHost host(maze, {.strict = true});
  std::string replies;
  for (const std::string& command : commands) host.obey(command, replies);
  EXPECT_EQ(replies.find("crash"), std::string::npos);
  EXPECT_EQ(host.invalid_lines(), 0);
  return host;
}

/// What the bound's witness scores is the bound.
void expect_witnessed(const Maze& maze) {
  const MmsBound bound = mms_bound_of(maze);
  ASSERT_TRUE(bound.score && bound.run);
  const MmsStatistics won = played(maze, mms_best_commands(maze)).statistics();
  ASSERT_TRUE(won.finished);
  ASSERT_EQ(won.score, static_cast<float>(*bound.score));
  ASSERT_EQ(won.best_run_effective_distance + won.best_run_turns, *bound.run);
}

TEST(MmsBound, OfOneCorridorIsOneMove) {
  const MmsBound bound = mms_bound_of(open_room(1, 9));
  EXPECT_EQ(bound.run, 4.5);  // 7 half steps: the goal begins at its south wall
  EXPECT_EQ(bound.score, 4.95);
  EXPECT_EQ(mms_best_commands(open_room(1, 9)), std::vector<std::string>{"moveForwardHalf 7"});
}

TEST(MmsBound, CountsATurnAtTheStartInTheTotalOnly) {
  const MmsBound bound = mms_bound_of(open_room(9, 1));
  EXPECT_EQ(bound.run, 4.5);
  EXPECT_EQ(bound.score, 5.05);
  EXPECT_EQ(mms_best_commands(open_room(9, 1)), (std::vector<std::string>{"turnRight", "moveForwardHalf 7"}));
}

TEST(MmsBound, TakesDiagonals) {
  const Maze maze = test::drawn(R"(
    o---o---o---o
    |       |   |
    o   o   o   o
    |   |       |
    o   o---o   o
    |   |     G |
    o---o---o---o
  )");
  EXPECT_EQ(mms_bound_of(maze).run, 8.5);
  EXPECT_EQ(mms_bound_of(maze).score, 9.35);
  EXPECT_EQ(mms_best_commands(maze),
            (std::vector<std::string>{"moveForwardHalf 3", "turnRight45", "moveForwardHalf 1", "turnRight",
                                      "moveForwardHalf 1", "turnRight45", "moveForwardHalf 1"}));
}

TEST(MmsBound, OfAnOpenRoomIsOneDiagonal) {
  const Maze maze = open_room(16, 16);
  EXPECT_EQ(mms_best_commands(maze),
            (std::vector<std::string>{"moveForwardHalf 1", "turnRight45", "moveForwardHalf 13"}));
  EXPECT_EQ(mms_bound_of(maze).run, 1 + 1 + 7.5);
  EXPECT_EQ(mms_bound_of(maze).score, 10.45);
}

TEST(MmsBound, WhereNoGoalCanBeReachedIsNothing) {
  const Maze maze(MazeDraft({3, 3}, MazeDraft::Inside::closed));
  EXPECT_EQ(mms_bound_of(maze).run, std::nullopt);
  EXPECT_EQ(mms_bound_of(maze).score, std::nullopt);
  EXPECT_TRUE(mms_best_commands(maze).empty());
}

TEST(MmsBound, WhereTheStartIsAGoalIsOneTurnInTheTotal) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 2}, {2, 1}, {2, 2}}) {
    EXPECT_EQ(mms_bound_of(open_room(width, height)).run, 0);
    EXPECT_EQ(mms_bound_of(open_room(width, height)).score, 0.1);
    expect_witnessed(open_room(width, height));
  }
}

TEST(MmsBound, GoesToTheCentreFromTheCornerWhateverTheMazeMarks) {
  const Maze maze = open_room(9, 1);
  const Maze marked = maze.with_start({8, 0}, Heading::west).with_goals(CellSet::of({7, 0}));
  EXPECT_EQ(mms_bound_of(marked).score, mms_bound_of(maze).score);
}

TEST(MmsBound, IsScoredByItsWitness) {
  Rng rng(11);
  for (int i = 0; i < test::tenth(300); ++i) {
    const Size size{1 + rng.below(20), 1 + rng.below(20)};
    const Generator* generator = i % 2 == 0 ? &prim_generator : &wilson_generator;
    expect_witnessed(generator->make({size, rng.bits(), rng.below(1001)}));
  }
}

TEST(MmsBound, IsScoredByItsWitnessInTheLargestMazes) {
  for (const Size size : {Size{64, 64}, {64, 1}, {1, 64}}) {
    expect_witnessed(open_room(size.width, size.height));
    expect_witnessed(depth_first_generator.make({size, 5, 0}));
  }
}

TEST(MmsBound, IsScoredByItsWitnessInContestMazes) {
  const auto files = test::maze_files();
  if (files.empty()) GTEST_SKIP() << "the folder of mazes is not here";
  for (std::size_t i = 0; i < files.size(); i += test::sanitized ? 10 : 1)
    if (const auto maze = test::maze_in_file(files[i]); maze && mms_bound_of(*maze).score) expect_witnessed(*maze);
}

/// Everything that a mouse may do, in the simulator itself: no cheaper way to score may be missing in the bound. States
/// that differ in their totals only are one: the lower total can do what the higher one can.
class Everything {
 public:
  /// Plays on from every state whose total of effective distance and turns is at most `most`.
  Everything(const Maze& maze, float most) : most_(most) {
    note(MmsHost(maze, {}));
    while (!open_.empty()) {
      const MmsHost host = open_.extract(open_.begin()).mapped();
      if (total_of(host) > reached_.at(key_of(host))) continue;
      for (const char* command : commands) note(after(host, command));
    }
  }

  std::optional<float> least_score, least_run;

 private:
  static constexpr std::array commands = {"turnLeft",          "turnRight",         "turnLeft45",
                                          "turnRight45",       "moveForwardHalf 1", "moveForwardHalf 2",
                                          "moveForwardHalf 3", "moveForwardHalf 4", "moveForwardHalf 5",
                                          "moveForwardHalf 6", "moveForward 1",     "ackReset"};
  using Key = std::tuple<int, int, int, float, float, float, bool, float>;

  static float total_of(const MmsHost& host) {
    return host.statistics().total_effective_distance + host.statistics().total_turns;
  }
  static Key key_of(const MmsHost& host) {
    const MmsStatistics& all = host.statistics();
    const float best = all.best_run_effective_distance + all.best_run_turns;
    return {host.pose().place.x,
            host.pose().place.y,
            static_cast<int>(host.pose().heading),
            all.current_run_effective_distance,
            all.current_run_turns,
            host.ledger().pending_penalty(),
            host.ledger().in_run(),
            best};
  }
  static MmsHost after(MmsHost host, const char* command) {
    std::string replies;
    host.obey(command, replies);
    return host;
  }

  void note(const MmsHost& host) {
    const float total = total_of(host);
    const MmsStatistics& all = host.statistics();
    if (all.finished) {
      const float run = all.best_run_effective_distance + all.best_run_turns;
      least_score = std::min(all.score, least_score.value_or(all.score));
      least_run = std::min(run, least_run.value_or(run));
    }
    if (total > most_) return;
    const auto [known, is_new] = reached_.try_emplace(key_of(host), total);
    if (!is_new && known->second <= total) return;
    known->second = total;
    open_.emplace(total, host);
  }

  float most_;
  std::map<Key, float> reached_;
  std::multimap<float, MmsHost> open_;
};

/// Up to a total that is `more` above that of the bound's own run, nobody scores less than the bound.
void expect_least(const Maze& maze, float more) {
  const MmsBound bound = mms_bound_of(maze);
  const Everything everything(maze, static_cast<float>(bound.run.value_or(5)) + more);
  EXPECT_EQ(everything.least_score.has_value(), bound.score.has_value());
  if (!bound.score) return;
  EXPECT_EQ(everything.least_score, static_cast<float>(*bound.score));
  EXPECT_EQ(everything.least_run, static_cast<float>(*bound.run));
}

TEST(MmsBound, IsTheLeastOfAllThatCanBeDoneInSmallMazes) {
  Rng rng(3);
  for (const Size size :
       {Size{1, 1}, {1, 2}, {2, 2}, {1, 3}, {3, 1}, {2, 3}, {3, 2}, {3, 3}, {3, 3}, {4, 3}, {3, 4}, {4, 4}})
    for (const int loops : {0, 400}) expect_least(wilson_generator.make({size, rng.bits(), loops}), 4);
}

TEST(MmsBound, IsTheLeastWithResetsAndReturnsToo) {
  LABMOUSE_SKIP_SANITIZED();
  // Enough for a reset and a run behind it, or for several runs.
  const int steps = test::thorough ? 18 : 15;
  for (const Size size : {Size{1, 1}, {2, 2}, {1, 3}, {3, 1}}) expect_least(open_room(size.width, size.height), steps);
}

TEST(MmsBound, WhereNoGoalCanBeReachedNobodyScores) {
  expect_least(Maze(MazeDraft({3, 3}, MazeDraft::Inside::closed)), 5);
}

}  // namespace
}  // namespace labmouse
