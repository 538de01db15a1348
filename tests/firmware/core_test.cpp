// The strategies behind the C interface make the same contests as in C++, in the memory that they promise.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <vector>

#include "labmouse/contest/simulator.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/capstone_mazes.hpp"
#include "tests/firmware/core_in_c.h"
#include "tests/strategies/random_mazes.hpp"

namespace labmouse {
namespace {

constexpr std::array strategies = {LABMOUSE_CORE_FLOOD, LABMOUSE_CORE_FLOOD_RETURN, LABMOUSE_CORE_CERTIFY,
                                   LABMOUSE_CORE_ARIADNE};
constexpr std::array mice = {&flood_mouse, &flood_return_mouse, &certify_mouse, &ariadne_mouse};

/// A mouse with its memory.
class Core {
 public:
  Core(const Maze& maze, labmouse_core_strategy strategy, int spare = 0) {
    maze.goals().for_each([&](Cell cell) {
      goals.push_back({static_cast<std::uint8_t>(cell.x), static_cast<std::uint8_t>(cell.y)});
    });
    const Size size = maze.size();
    const auto side = static_cast<std::size_t>(std::max(size.width, size.height));
    memory.resize(LABMOUSE_CORE_MEMORY(side, strategy) + static_cast<std::size_t>(spare));
    kind = strategy;
    briefing = {static_cast<std::uint8_t>(size.width),
                static_cast<std::uint8_t>(size.height),
                static_cast<std::uint8_t>(maze.start().x),
                static_cast<std::uint8_t>(maze.start().y),
                static_cast<std::uint8_t>(quarters_between(Heading::north, maze.start_heading())),
                reinterpret_cast<const std::uint8_t(*)[2]>(goals.data()),
                static_cast<std::uint8_t>(goals.size()),
                3,
                max_side,
                1000};
    status = labmouse_core_create(memory.data(), memory.size(), strategy, &briefing, &mouse);
  }

  labmouse_core_status observe(const Sighting& seen) {
    return labmouse_core_observe(mouse, static_cast<std::uint8_t>(seen.left), static_cast<std::uint8_t>(seen.ahead),
                                 static_cast<std::uint8_t>(seen.right));
  }

  std::vector<std::array<std::uint8_t, 2>> goals;
  std::vector<unsigned char> memory;
  labmouse_core_strategy kind;
  labmouse_core_maze briefing;
  labmouse_core* mouse = nullptr;
  labmouse_core_status status;
};

std::vector<Action> actions_of(const RunRecord& record) {
  std::vector<Action> actions;
  for (const StepRecord& step : record.steps) actions.push_back(step.action);
  return actions;
}

/// Its contest, from where it is.
RunRecord contest_of(Core& core, const Maze& maze) {
  Contest contest(maze, {});
  while (!contest.ended()) {
    EXPECT_EQ(core.observe(contest.sighting()), LABMOUSE_CORE_OK);
    labmouse_core_action action;
    const labmouse_core_status status = labmouse_core_decide(core.mouse, &action);
    if (status != LABMOUSE_CORE_OK) {
      EXPECT_EQ(status, LABMOUSE_CORE_NO_ROUTE);
      contest.act(Action::forfeit(ForfeitReason::no_route));
    } else if (action.kind == LABMOUSE_CORE_RESET) {
      contest.act(Action::reset());
    } else {
      EXPECT_EQ(action.kind, LABMOUSE_CORE_STEP);
      contest.act(Action::step(90 * action.quarters, action.cells));
    }
  }
  if (contest.record().outcome == Outcome::finished) {
    EXPECT_EQ(core.observe(contest.sighting()), LABMOUSE_CORE_OK);
    labmouse_core_action action;
    EXPECT_EQ(labmouse_core_decide(core.mouse, &action), LABMOUSE_CORE_OK);
    EXPECT_EQ(action.kind, LABMOUSE_CORE_END);
    EXPECT_EQ(core.observe(contest.sighting()), LABMOUSE_CORE_ORDER);
  }
  return contest.take_record();
}

void expect_same_contests(const Maze& maze) {
  SCOPED_TRACE(test::drawing_of(maze));
  for (std::size_t i = 0; i < strategies.size(); ++i) {
    SCOPED_TRACE(mice[i]->name);
    const Settings settings(mice[i]->parameters);
    const RunRecord record = run(maze, {}, *mice[i]->make(brief(maze, {}, 1), settings));
    Core core(maze, strategies[i]);
    ASSERT_EQ(core.status, LABMOUSE_CORE_OK);
    for (int again = 0; again < 2; ++again) {
      const RunRecord its = contest_of(core, maze);
      ASSERT_EQ(its.outcome, record.outcome);
      ASSERT_EQ(actions_of(its), actions_of(record));
      ASSERT_EQ(labmouse_core_reset(core.mouse), LABMOUSE_CORE_OK);
    }
  }
}

TEST(Core, HasTheSameContestsInEveryBuiltinMaze) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(LABMOUSE_SOURCE_DIR "/mazes"))
    if (const auto maze = test::maze_in_file(entry.path())) {
      ASSERT_NO_FATAL_FAILURE(expect_same_contests(*maze));
      ++count;
    }
  EXPECT_GT(count, 40);
}

TEST(Core, HasTheSameContestsFromOtherStartsAndWhereNoRouteIsLeft) {
  Rng rng(1);
  for (int i = 0; i < 100; ++i) ASSERT_NO_FATAL_FAILURE(expect_same_contests(test::any_maze(rng, 24)));
}

TEST(Core, FitsIntoTheMemoryThatItNeedsAndIntoNoLess) {
  for (int side = 1; side <= max_side; ++side)
    for (const labmouse_core_strategy strategy : strategies)
      for (const Size size : {Size{side, side}, Size{side, 1}, Size{1, side}}) {
        const Maze maze(MazeDraft(size, MazeDraft::Inside::open));
        EXPECT_EQ(Core(maze, strategy).status, LABMOUSE_CORE_OK);
        EXPECT_EQ(Core(maze, strategy, 13).status, LABMOUSE_CORE_OK);
        EXPECT_EQ(Core(maze, strategy, -1).status, LABMOUSE_CORE_MEMORY_SHORT);
        EXPECT_EQ(Core(maze, strategy, -1).mouse, nullptr);
      }
}

TEST(Core, NeedsTheSameMemoryInC) {
  for (std::size_t i = 0; i < strategies.size(); ++i) {
    EXPECT_EQ(core_in_c_bytes[i][0], LABMOUSE_CORE_MEMORY(16, strategies[i]));
    EXPECT_EQ(core_in_c_bytes[i][1], LABMOUSE_CORE_MEMORY(32, strategies[i]));
  }
  EXPECT_EQ(core_in_c_first_step(), 1);
}

Maze some_maze() { return test::maze_in_file(LABMOUSE_SOURCE_DIR "/mazes/contest-05.txt").value(); }

/// Searches a maze and saves the map; the actions of the speed run.
std::vector<Action> searched(Core& core, const Maze& maze, std::vector<std::uint8_t>& saved) {
  std::vector<Action> run;
  bool racing = false;
  for (const Action& action : actions_of(contest_of(core, maze))) {
    if (racing) run.push_back(action);
    racing = racing || action.kind == Action::Kind::reset;
  }
  std::size_t used = 0;
  saved.assign(LABMOUSE_CORE_SAVED(16), 0);
  EXPECT_EQ(labmouse_core_save(core.mouse, saved.data(), saved.size(), &used), LABMOUSE_CORE_OK);
  EXPECT_EQ(used, saved.size());
  return run;
}

TEST(Core, MakesTheSameSpeedRunOnARestoredMap) {
  const Maze maze = some_maze();
  for (const labmouse_core_strategy strategy : strategies) {
    Core core(maze, strategy);
    std::vector<std::uint8_t> saved;
    const std::vector<Action> expected = searched(core, maze, saved);
    Core other(maze, strategy);
    ASSERT_EQ(labmouse_core_restore(other.mouse, saved.data(), saved.size()), LABMOUSE_CORE_OK);
    std::vector<Action> run;
    Pose pose{maze.start(), maze.start_heading()};
    for (;;) {
      ASSERT_EQ(other.observe(look(maze, pose)), LABMOUSE_CORE_OK);
      labmouse_core_action action;
      ASSERT_EQ(labmouse_core_decide(other.mouse, &action), LABMOUSE_CORE_OK);
      if (action.kind == LABMOUSE_CORE_END) break;
      run.push_back(Action::step(90 * action.quarters, action.cells));
      pose = after(pose, run.back());
    }
    EXPECT_EQ(run, expected);
    std::vector<std::uint8_t> again(saved.size());
    std::size_t used = 0;
    ASSERT_EQ(labmouse_core_save(other.mouse, again.data(), again.size(), &used), LABMOUSE_CORE_OK);
    EXPECT_EQ(again, saved);
  }
}

TEST(Core, RefusesACorruptedMap) {
  const Maze maze = some_maze();
  Core core(maze, LABMOUSE_CORE_FLOOD), other(maze, LABMOUSE_CORE_FLOOD);
  std::vector<std::uint8_t> saved;
  searched(core, maze, saved);
  const std::vector<unsigned char> before = other.memory;
  for (std::size_t at = 0; at < saved.size(); ++at)
    for (unsigned bit = 1; bit < 256; bit *= 2) {
      std::vector<std::uint8_t> bad = saved;
      bad[at] = static_cast<std::uint8_t>(bad[at] ^ bit);
      ASSERT_EQ(labmouse_core_restore(other.mouse, bad.data(), bad.size()), LABMOUSE_CORE_BAD_MAP);
    }
  for (std::size_t bytes = 0; bytes < saved.size(); ++bytes)
    ASSERT_EQ(labmouse_core_restore(other.mouse, saved.data(), bytes), LABMOUSE_CORE_BAD_MAP);
  EXPECT_EQ(other.memory, before);
  Core larger(Maze(MazeDraft({17, 16}, MazeDraft::Inside::open)), LABMOUSE_CORE_FLOOD);
  EXPECT_EQ(labmouse_core_restore(larger.mouse, saved.data(), saved.size()), LABMOUSE_CORE_BAD_MAP);
}

TEST(Core, RefusesNullPointers) {
  Core core(some_maze(), LABMOUSE_CORE_FLOOD);
  labmouse_core_action action;
  labmouse_core* mouse = nullptr;
  std::array<std::uint8_t, LABMOUSE_CORE_SAVED(16)> saved{};
  std::size_t used = 0;
  labmouse_core_maze without_goals = core.briefing;
  without_goals.goals = nullptr;
  const std::size_t bytes = core.memory.size();
  std::vector<unsigned char> memory(bytes);
  for (const labmouse_core_status status :
       {labmouse_core_create(nullptr, bytes, core.kind, &core.briefing, &mouse),
        labmouse_core_create(memory.data(), bytes, core.kind, nullptr, &mouse),
        labmouse_core_create(memory.data(), bytes, core.kind, &without_goals, &mouse),
        labmouse_core_create(memory.data(), bytes, core.kind, &core.briefing, nullptr), labmouse_core_reset(nullptr),
        labmouse_core_observe(nullptr, 0, 0, 0), labmouse_core_decide(nullptr, &action),
        labmouse_core_decide(core.mouse, nullptr), labmouse_core_save(nullptr, saved.data(), saved.size(), &used),
        labmouse_core_save(core.mouse, nullptr, saved.size(), &used),
        labmouse_core_save(core.mouse, saved.data(), saved.size(), nullptr),
        labmouse_core_restore(nullptr, saved.data(), saved.size()),
        labmouse_core_restore(core.mouse, nullptr, saved.size())})
    EXPECT_EQ(status, LABMOUSE_CORE_NULL);
}

TEST(Core, RefusesAWrongOrderOfCalls) {
  Core core(some_maze(), LABMOUSE_CORE_FLOOD);
  labmouse_core_action action;
  std::array<std::uint8_t, LABMOUSE_CORE_SAVED(16)> saved{};
  std::size_t used = 0;
  EXPECT_EQ(labmouse_core_decide(core.mouse, &action), LABMOUSE_CORE_ORDER);
  EXPECT_EQ(labmouse_core_save(core.mouse, saved.data(), saved.size() - 1, &used), LABMOUSE_CORE_MEMORY_SHORT);
  ASSERT_EQ(labmouse_core_save(core.mouse, saved.data(), saved.size(), &used), LABMOUSE_CORE_OK);
  ASSERT_EQ(core.observe({0, 1, 0}), LABMOUSE_CORE_OK);
  EXPECT_EQ(core.observe({0, 1, 0}), LABMOUSE_CORE_ORDER);
  EXPECT_EQ(labmouse_core_restore(core.mouse, saved.data(), saved.size()), LABMOUSE_CORE_ORDER);
  ASSERT_EQ(labmouse_core_decide(core.mouse, &action), LABMOUSE_CORE_OK);
  EXPECT_EQ(labmouse_core_decide(core.mouse, &action), LABMOUSE_CORE_ORDER);
  EXPECT_EQ(labmouse_core_restore(core.mouse, saved.data(), saved.size()), LABMOUSE_CORE_ORDER);
  ASSERT_EQ(core.observe({0, 0, 1}), LABMOUSE_CORE_OK);
  EXPECT_EQ(labmouse_core_reset(core.mouse), LABMOUSE_CORE_OK);
  EXPECT_EQ(labmouse_core_restore(core.mouse, saved.data(), saved.size()), LABMOUSE_CORE_OK);
  ASSERT_EQ(core.observe({0, 1, 0}), LABMOUSE_CORE_OK);
  EXPECT_EQ(labmouse_core_decide(core.mouse, &action), LABMOUSE_CORE_NO_ROUTE);  // the map was empty
  EXPECT_EQ(core.observe({0, 1, 0}), LABMOUSE_CORE_ORDER);
}

TEST(Core, RefusesReadingsThatContradictTheMap) {
  Core core(some_maze(), LABMOUSE_CORE_CERTIFY);
  labmouse_core_action action;
  ASSERT_EQ(core.observe({1, 0, 0}), LABMOUSE_CORE_OK);  // through the border
  EXPECT_EQ(labmouse_core_decide(core.mouse, &action), LABMOUSE_CORE_CONTRADICTION);
  EXPECT_EQ(core.observe({0, 0, 0}), LABMOUSE_CORE_ORDER);
  EXPECT_EQ(labmouse_core_reset(core.mouse), LABMOUSE_CORE_OK);
  EXPECT_EQ(core.observe({0, 0, 0}), LABMOUSE_CORE_OK);
}

TEST(Core, RefusesArgumentsOutOfRange) {
  Core core(some_maze(), LABMOUSE_CORE_FLOOD);
  const std::uint8_t goal[1][2] = {{16, 0}};
  std::vector<labmouse_core_maze> bad(13, core.briefing);
  bad[0].width = 0, bad[1].height = 0, bad[2].width = 65, bad[3].height = 65, bad[4].x = 16, bad[5].y = 16;
  bad[6].heading = 4, bad[7].goals = goal, bad[7].goal_count = 1, bad[8].goal_count = 0, bad[9].longest = 0;
  bad[10].longest = 9, bad[11].sight = 0, bad[12].budget = 0;
  std::vector<unsigned char> memory(LABMOUSE_CORE_MEMORY(64, LABMOUSE_CORE_ARIADNE));
  labmouse_core* mouse = nullptr;
  for (const labmouse_core_maze& maze : bad)
    EXPECT_EQ(labmouse_core_create(memory.data(), memory.size(), LABMOUSE_CORE_FLOOD, &maze, &mouse),
              LABMOUSE_CORE_RANGE);
  EXPECT_EQ(labmouse_core_create(memory.data(), memory.size(), 4, &core.briefing, &mouse), LABMOUSE_CORE_RANGE);
  for (const Sighting& seen : {Sighting{65, 0, 0}, Sighting{0, 65, 0}, Sighting{0, 0, 65}})
    EXPECT_EQ(core.observe(seen), LABMOUSE_CORE_RANGE);
}

}  // namespace
}  // namespace labmouse
