// What every mouse of the list of built-in mice promises, in every maze.
#include <gtest/gtest.h>

#include <map>

#include "labmouse/chance/rng.hpp"
#include "labmouse/contest/score.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/maze/routes.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/slowness.hpp"
#include "tests/strategies/allocations.hpp"
#include "tests/strategies/contract_mazes.hpp"
#include "tests/strategies/counting_mouse.hpp"
#include "tests/strategies/mouse_name.hpp"

namespace labmouse {
namespace {

using test::contract_mazes;
using test::ContractMaze;

bool has_route(const Maze& maze) { return shortest_in_cells(maze).has_value(); }

std::unique_ptr<Strategy> make(const BuiltinMouse& mouse, const Maze& maze, const Rules& rules = {},
                               std::uint64_t seed = 1) {
  return mouse.make(brief(maze, rules, seed), Settings(mouse.parameters));
}

RunRecord run_of(const BuiltinMouse& mouse, const Maze& maze, const Rules& rules = {}, std::uint64_t seed = 1) {
  return run(maze, rules, *make(mouse, maze, rules, seed));
}

/// The mouse's record in each of the mazes, run once for all tests of the program.
const std::vector<RunRecord>& records_of(const BuiltinMouse& mouse) {
  static std::map<const BuiltinMouse*, std::vector<RunRecord>> records;
  std::vector<RunRecord>& of_mouse = records[&mouse];
  if (of_mouse.empty())
    for (const ContractMaze& maze : contract_mazes()) of_mouse.push_back(run_of(mouse, maze.maze));
  return of_mouse;
}

/// Stands between a contest and a mouse and looks at what the mouse believes after each decision.
class Examiner final : public test::CountingMouse {
 public:
  Examiner(Strategy& mouse, const Maze& maze) : CountingMouse(mouse), maze_(maze) {}

  Action decide(const Sighting& seen) override {
    const WallSet open = knowledge().open(), unknown = knowledge().unknown();
    const Action action = CountingMouse::decide(seen);
    examine(open, unknown);
    return action;
  }
  bool imagines_passages() const { return imagines_passages_; }
  bool imagines_walls() const { return imagines_walls_; }
  bool forgets() const { return forgets_; }

 private:
  static bool within(WallSet walls, const WallSet& others) { return (walls -= others).empty(); }

  void examine(const WallSet& open, const WallSet& unknown) {
    const Knowledge& now = knowledge();
    imagines_passages_ |= !within(now.open(), maze_.open_walls());
    imagines_walls_ |= !within(maze_.open_walls(), now.possible());
    forgets_ |= !within(open, now.open()) || !within(now.unknown(), unknown);
  }

  const Maze& maze_;
  bool imagines_passages_ = false;
  bool imagines_walls_ = false;
  bool forgets_ = false;
};

class EveryMouse : public testing::TestWithParam<const BuiltinMouse*> {
 protected:
  const BuiltinMouse& mouse() const { return *GetParam(); }

  /// Hands the record of the mouse in each maze to check(maze, record).
  template <class Check>
  void in_every_maze(Check check) const {
    for (std::size_t i = 0; i < contract_mazes().size(); ++i) {
      SCOPED_TRACE(contract_mazes()[i].name);
      check(contract_mazes()[i].maze, records_of(mouse())[i]);
    }
  }
  /// Runs the mouse in each maze before an examiner and hands that to check(examiner).
  template <class Check>
  void examined_in_every_maze(Check check) const {
    for (const ContractMaze& maze : contract_mazes()) {
      SCOPED_TRACE(maze.name);
      const auto strategy = make(mouse(), maze.maze);
      Examiner examiner(*strategy, maze.maze);
      run(maze.maze, {}, examiner);
      check(examiner);
    }
  }
};

TEST_P(EveryMouse, EndsItsRunOrItsBudget) {
  in_every_maze([](const Maze& maze, const RunRecord& record) {
    EXPECT_FALSE(record.steps.empty());
    if (record.outcome == Outcome::finished) {
      EXPECT_TRUE(maze.is_goal(record.end.cell));
    } else if (record.outcome != Outcome::forfeit) {
      EXPECT_EQ(record.steps.size(), 1000U);
    }
  });
}

TEST_P(EveryMouse, GivesUpOnlyWhereThereIsNoWay) {
  in_every_maze([](const Maze& maze, const RunRecord& record) {
    if (record.outcome != Outcome::forfeit) return;
    EXPECT_FALSE(has_route(maze));
    EXPECT_EQ(record.steps.back().action.reason, ForfeitReason::no_route);
  });
}

TEST_P(EveryMouse, NeverRunsIntoAWall) {
  in_every_maze([](const Maze&, const RunRecord& record) {
    for (const StepRecord& step : record.steps) ASSERT_FALSE(step.blocked) << "step " << step.step;
  });
}

TEST_P(EveryMouse, AsksForNothingThatTheWorldDoesNotPerform) {
  in_every_maze([](const Maze&, const RunRecord& record) {
    for (const StepRecord& step : record.steps) {
      ASSERT_EQ(step.action.rotation % 90, 0);
      ASSERT_LE(std::abs(step.action.rotation), 90);
      ASSERT_LE(std::abs(step.action.movement), 3);
    }
  });
}

TEST_P(EveryMouse, ResetsOnceAndOnlyWhenItMay) {
  in_every_maze([](const Maze&, const RunRecord& record) {
    int resets = 0, performed = 0;
    for (std::size_t i = 0; i < record.steps.size(); ++i) {
      if (record.steps[i].action.kind == Action::Kind::reset) ++resets;
      if (i > 0 && record.steps[i].run != record.steps[i - 1].run) ++performed;
    }
    EXPECT_LE(resets, 1);
    EXPECT_TRUE(resets == performed || record.steps.back().action.kind == Action::Kind::reset);
  });
}

TEST_P(EveryMouse, BelievesOnlyInPassagesThatAreThere) {
  examined_in_every_maze([](const Examiner& examiner) { EXPECT_FALSE(examiner.imagines_passages()); });
}

TEST_P(EveryMouse, BelievesOnlyInWallsThatAreThere) {
  examined_in_every_maze([](const Examiner& examiner) { EXPECT_FALSE(examiner.imagines_walls()); });
}

TEST_P(EveryMouse, ForgetsNothing) {
  examined_in_every_maze([](const Examiner& examiner) { EXPECT_FALSE(examiner.forgets()); });
}

TEST_P(EveryMouse, TakesNoMemoryOnceItIsMade) {
  examined_in_every_maze([](const Examiner& examiner) { EXPECT_EQ(examiner.allocations(), 0); });
}

TEST_P(EveryMouse, KnowsAllThatItHasSeen) {
  for (const ContractMaze& maze : contract_mazes()) {
    SCOPED_TRACE(maze.name);
    const auto strategy = make(mouse(), maze.maze);
    Knowledge seen(maze.maze.size());
    for (const StepRecord& step : run(maze.maze, {}, *strategy).steps)
      ASSERT_TRUE(seen.learn(step.pose, step.sighting));
    EXPECT_EQ(strategy->knowledge().open(), seen.open());
    EXPECT_EQ(strategy->knowledge().possible(), seen.possible());
  }
}

TEST_P(EveryMouse, DoesTheSameForTheSameSeedAlsoAfterAnother) {
  const Maze elsewhere = kruskal_generator.make({{9, 9}, 2, 100});
  for (const ContractMaze& maze : contract_mazes()) {
    SCOPED_TRACE(maze.name);
    const RunRecord before = run_of(mouse(), maze.maze);
    run_of(mouse(), elsewhere, {}, 99);
    EXPECT_EQ(run_of(mouse(), maze.maze), before);
  }
}

TEST_P(EveryMouse, DoesTheSameWhileAnotherRuns) {
  const Maze maze = prim_generator.make({{16, 16}, 3, 100});
  const RunRecord alone = run_of(mouse(), maze);
  // Two strategies, asked in turns: what they share would show.
  const auto one = make(mouse(), maze), other = make(mouse(), maze);
  for (const StepRecord& step : alone.steps) {
    ASSERT_EQ(one->decide(step.sighting), step.action);
    ASSERT_EQ(other->decide(step.sighting), step.action);
  }
}

TEST_P(EveryMouse, IsStochasticOnlyWhereItsEntrySaysSo) {
  const Maze maze = prim_generator.make({{16, 16}, 3, 100});
  EXPECT_NE(run_of(mouse(), maze, {}, 1) == run_of(mouse(), maze, {}, 2),
            mouse().uses_chance(Settings(mouse().parameters)));
}

TEST_P(EveryMouse, GivesUpWhereAReadingContradictsAnother) {
  const Maze maze(MazeDraft({5, 5}, MazeDraft::Inside::open));
  const auto strategy = make(mouse(), maze);
  ASSERT_EQ(strategy->decide({0, 4, 4}).kind, Action::Kind::step);
  EXPECT_EQ(strategy->decide({9, 9, 9}), Action::forfeit(ForfeitReason::contradiction));
}

/// Values of a parameter to try beside the default.
std::vector<std::string> values_of(const Parameter& parameter) {
  switch (parameter.type) {
    case ParameterType::flag:
      return {"yes", "no"};
    case ParameterType::choice:
    case ParameterType::prior: {
      std::vector<std::string> values;
      std::string_view rest = parameter.choices;
      for (std::size_t end; (end = rest.find('/')) != std::string_view::npos; rest.remove_prefix(end + 1))
        values.emplace_back(rest.substr(0, end));
      values.emplace_back(rest);
      return values;
    }
    case ParameterType::list:  // the default with one number, in turn, at each end of the range
    case ParameterType::whole:
    case ParameterType::real:
      break;
  }
  const auto number = [](double value) {
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    return text.back() == '.' ? text.substr(0, text.size() - 1) : text;
  };
  if (parameter.type != ParameterType::list) return {number(parameter.low), number(parameter.high)};
  const std::string list(parameter.default_value);
  const std::string tail = list.find('/') == std::string::npos ? "" : list.substr(list.find('/'));
  return {number(parameter.low) + tail, number(parameter.high) + tail};
}

/// Whether another value of the parameter makes another walk, where the others are set so.
bool changes_something(const BuiltinMouse& mouse, const Parameter& parameter, const Settings& others) {
  for (const std::string& value : values_of(parameter)) {
    EXPECT_EQ(check_value(parameter, value), "") << value;
    Settings settings = others;
    settings.set(parameter.name, value);
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
      for (const Maze& maze :
           {prim_generator.make({{16, 16}, seed, 300}), contest_generator.make({{16, 16}, seed, 0})}) {
        const Briefing briefing = brief(maze, {}, 1);
        if (run(maze, {}, *mouse.make(briefing, settings)) != run(maze, {}, *mouse.make(briefing, others))) return true;
      }
  }
  return false;
}

/// Whether the parameter does so beside the defaults, or beside an extreme of another one that it belongs to.
bool changes_something(const BuiltinMouse& mouse, const Parameter& parameter) {
  const Settings defaults(mouse.parameters);
  if (changes_something(mouse, parameter, defaults)) return true;
  for (const Parameter& other : mouse.parameters) {
    if (other.name == parameter.name) continue;
    for (const std::string& value : values_of(other)) {
      Settings settings = defaults;
      settings.set(other.name, value);
      if (changes_something(mouse, parameter, settings)) return true;
    }
  }
  return false;
}

TEST_P(EveryMouse, HasParametersWhoseDefaultsLieInTheirRange) {
  for (const Parameter& parameter : mouse().parameters)
    EXPECT_EQ(check_value(parameter, parameter.default_value), "") << parameter.name;
}

TEST_P(EveryMouse, HasParametersThatSayWhatTheyMean) {
  for (const Parameter& parameter : mouse().parameters) {
    EXPECT_FALSE(parameter.name.empty());
    EXPECT_FALSE(parameter.meaning.empty());
  }
}

TEST_P(EveryMouse, HasNoParameterWithoutEffect) {
  if (test::sanitized) GTEST_SKIP() << "where a parameter has an effect is no question for sanitizers";
  // Every pair of parameters is tried: of the mice with many, only `make proof` has the time.
  if (!test::thorough && mouse().parameters.size() > 12) return;
  for (const Parameter& parameter : mouse().parameters) {
    const bool in_steps = parameter.scope != ParameterScope::seconds;
    EXPECT_TRUE(!in_steps || changes_something(mouse(), parameter)) << parameter.name;
  }
}

INSTANTIATE_TEST_SUITE_P(BuiltinMice, EveryMouse, testing::ValuesIn(builtin_mice().begin(), builtin_mice().end()),
                         test::mouse_name);

/// The mice that always arrive.
class SureMouse : public EveryMouse {};

TEST_P(SureMouse, SolvesEveryMazeWithARouteWhereTheBudgetAllows) {
  Rules patient;
  patient.budget = 1'000'000;
  for (const ContractMaze& maze : contract_mazes())
    EXPECT_EQ(run_of(mouse(), maze.maze, patient).outcome == Outcome::finished, has_route(maze.maze)) << maze.name;
}

TEST_P(SureMouse, KnowsWhereThereIsNoRoute) {
  Rules patient;
  patient.budget = 1'000'000;
  for (const ContractMaze& maze : contract_mazes())
    if (!has_route(maze.maze)) {
      EXPECT_EQ(run_of(mouse(), maze.maze, patient).outcome, Outcome::forfeit) << maze.name;
    }
}

INSTANTIATE_TEST_SUITE_P(BuiltinMice, SureMouse,
                         testing::Values(&flood_mouse, &flood_return_mouse, &certify_mouse, &flood_block_mouse,
                                         &phases_mouse, &two_way_mouse, &frontier_mouse),
                         test::mouse_name);

Maze generated(Rng& rng) {
  for (;;) {
    const Generator& generator =
        *all_generators()[static_cast<std::size_t>(rng.below(static_cast<int>(all_generators().size())))];
    const GeneratorOrder order{{1 + rng.below(20), 1 + rng.below(20)}, rng.bits(), rng.below(400)};
    if (generator.refuses(order).empty())
      return generator.make(order).with_start(order.size.cell_at(rng.below(order.size.area())),
                                              all_headings[static_cast<std::size_t>(rng.below(4))]);
  }
}

TEST(Certify, RacesAShortestRunInEveryMaze) {
  Rng rng(300);
  Rules patient;
  patient.budget = 1'000'000;
  for (int i = 0; i < 300; ++i) {
    const Maze maze = generated(rng);
    patient.stride = 1 + i % 4;
    const auto shortest = shortest_in_strides(maze, patient.stride);
    if (!shortest) continue;
    const Score result = score(run_of(certify_mouse, maze, patient), patient);
    ASSERT_EQ(result.outcome, Outcome::finished) << i;
    ASSERT_EQ(result.speed_steps, shortest->strides)
        << *drawing_format.write(maze.with_start(maze.start(), Heading::north)).content;
  }
}

TEST(Certify, SeesNoMoreThanItNeedsForTheProof) {
  // The goal is two cells ahead in the open: no wall elsewhere can matter.
  const Maze maze = test::drawn(R"(
    o---o---o---o---o---o
    |   | G |           |
    o   o   o   o---o   o
    |   |   |   |   |   |
    o   o   o   o   o   o
    |   | S |   |       |
    o---o---o---o---o---o
  )");
  const Score result = score(run_of(certify_mouse, maze), Rules());
  EXPECT_EQ(result.search_steps, 2);
  EXPECT_EQ(result.speed_steps, 1);
}

TEST(Certify, ResetsWhileTheBudgetStillAllowsTheKnownRoute) {
  const Maze maze = depth_first_generator.make({{16, 16}, 6, 100});
  const std::size_t needed = run_of(certify_mouse, maze).steps.size();
  Rules rules;
  int least = 1;
  for (rules.budget = least; run_of(certify_mouse, maze, rules).outcome != Outcome::finished; rules.budget = ++least) {
  }
  EXPECT_LT(least, static_cast<int>(needed) / 2);
  for (rules.budget = least; rules.budget <= static_cast<int>(needed); ++rules.budget)
    EXPECT_EQ(run_of(certify_mouse, maze, rules).outcome, Outcome::finished) << rules.budget;
}

TEST(FloodReturn, StandsAtTheStartBeforeItResets) {
  for (const ContractMaze& maze : contract_mazes())
    for (const StepRecord& step : run_of(flood_return_mouse, maze.maze).steps)
      if (step.action.kind == Action::Kind::reset) {
        EXPECT_EQ(step.pose.cell, maze.maze.start()) << maze.name;
      }
}

TEST(Flood, ResetsWithTheStepAfterTheGoal) {
  const Maze maze = depth_first_generator.make({{16, 16}, 4, 50});
  for (const StepRecord& step : run_of(flood_mouse, maze).steps) {
    EXPECT_EQ(step.run == Run::search_run && maze.is_goal(step.pose.cell), step.action.kind == Action::Kind::reset);
  }
}

TEST(BuiltinMice, HasEachNameOnce) {
  for (const BuiltinMouse* entry : builtin_mice()) {
    EXPECT_EQ(find_mouse(entry->name), entry);
    EXPECT_FALSE(entry->summary.empty());
  }
  EXPECT_EQ(find_mouse("cat"), nullptr);
}

TEST(Allocations, AreCounted) {
  const long before = test::allocations();
  ::operator delete(::operator new(10));
  EXPECT_EQ(test::allocations(), before + 1);
}

}  // namespace
}  // namespace labmouse
