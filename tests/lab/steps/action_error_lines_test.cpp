#include "labmouse/lab/steps/action_error_lines.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "labmouse/contest/script.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/standings/race_table.hpp"
#include "labmouse/lab/worlds/entering.hpp"
#include "tests/lab/records/record_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

const std::vector<Action> solution = {Action::step(90, 3), Action::step(90, 1), Action::step(90, 3), Action::reset(),
                                      Action::step(90, 3), Action::step(90, 1), Action::step(90, 3)};
/// All kinds of action errors, in the corridor; the mouse gives up in step 7.
const std::vector<Action> clumsy = {Action::step(90, 3),  Action::step(0, 1),  Action::step(0, 2),
                                    Action::step(180, 0), Action::step(0, -5), Action::reset()};

/// A mouse that plays these actions.
Contestant player(std::string name, const std::vector<Action>& actions) {
  Contestant mouse;
  mouse.name = std::move(name);
  const auto make = [actions](const Maze& maze, const Briefing&) {
    return std::make_unique<Script>(maze.size(), actions);
  };
  mouse.kind = Decider{make};
  return mouse;
}

RecordFile played(const std::vector<Action>& actions, const Rules& rules = {}) {
  const NamedMaze maze = test::corridor();
  const Contestant mouse = player("robot", actions);
  const auto strategy = mouse.strategy(maze.maze, brief(maze.maze, rules, 1));
  return record_file_of(mouse, maze, rules, 1, run(maze.maze, rules, *strategy));
}

/// The lines of a text, without their ends.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> list;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) list.push_back(line);
  return list;
}

TEST(ActionErrorLines, NameTheFirstStepOfEachKind) {
  EXPECT_THAT(
      lines_of(action_error_lines(played(clumsy))),
      ElementsAre(Says("2 of 7 steps", "blocked by a wall", "first step 2 at (3,1) heading east: turn +0, move +1"),
                  Says("1 of 7 steps", "void turn", "step 4 at (3,1) heading east: turn +180, move +0"),
                  Says("1 of 7 steps", "cut to 3 cells", "step 5 at (3,1) heading east: turn +0, move -5"),
                  Says("1 of 7 steps", "reset", "step 6 at (0,1) heading east: reset")));
}

TEST(ActionErrorLines, OfSeveralAreInThePlural) {
  Rules rules;
  rules.stride = 1;
  const auto lines = lines_of(
      action_error_lines(played({Action::reset(), Action::step(45, 2), Action::step(45, -2), Action::reset()}, rules)));
  EXPECT_THAT(lines, IsSupersetOf({Says("2 of 5 steps", "void turn", "first step 2 at"),
                                   Says("2 of 5 steps", "were cut to 1 cell,", "first step 2 at"),
                                   Says("2 of 5 steps", "were resets", "first step 1 at")}));
}

TEST(ActionErrorLines, OfAMouseWithoutActionErrorsThereAreNone) { EXPECT_EQ(action_error_lines(played(solution)), ""); }

TEST(ActionErrorLines, OfOurMiceThereAreNone) {
  EXPECT_EQ(action_error_lines(hold_race(residents_of(*first_world()), {test::loop(), test::hook()}, test::in_steps())),
            "");
}

TEST(ActionErrorLines, OfARaceAreTotalsWithTheFirstStep) {
  const Race race = hold_race(
      {player("program:./a", clumsy), player("program:./b", solution), player("program:./c", {Action::step(0, 1)})},
      {test::corridor(), test::without_route()}, test::in_steps());
  EXPECT_THAT(
      action_error_lines(race),
      HasSubstr("\n  program:./a: 6 blocked by walls, 2 void rotations, 2 cut movements, 2 idle resets; first in "
                "corridor, step 2\n"
                "  program:./b: 6 blocked by walls, 1 idle reset; first in without-route, step 1\n"));
  EXPECT_THAT(action_error_lines(race), EndsWith("\n  program:./c: 2 blocked by walls; first in corridor, step 1\n"));
  EXPECT_THAT(table_of(race, false), HasSubstr(action_error_lines(race)));
}

TEST(ActionErrorLines, OfARaceSayOneOfEachInTheSingular) {
  const Race race =
      hold_race({player("clumsy", {Action::step(180, 0), Action::step(90, 4), Action::step(0, 1), Action::reset()})},
                {test::corridor()}, test::in_steps());
  EXPECT_THAT(
      action_error_lines(race),
      EndsWith(": 1 blocked by a wall, 1 void rotation, 1 cut movement, 1 idle reset; first in corridor, step 1\n"));
}

TEST(ActionErrorLines, OfALaterRunSayWhichItIs) {
  Contestant mouse = player("clumsy", clumsy);
  mouse.runs = 3;
  const auto make = [](const Maze& maze, const Briefing& briefing) {
    return std::make_unique<Script>(maze.size(), briefing.seed == contest_seed(1, "corridor", 0) ? solution : clumsy);
  };
  mouse.kind = Decider{make};
  const std::string lines = action_error_lines(hold_race({mouse}, {test::corridor()}, test::in_steps()));
  EXPECT_THAT(lines, HasSubstr("clumsy: 4 blocked by walls, 2 void"));
  EXPECT_THAT(lines, HasSubstr("; first in corridor, run 2, step 2\n"));
}

TEST(ActionErrorLines, OfContestsThatWereNotDoneThereAreNone) {
  Race race = hold_race({player("clumsy", clumsy)}, {test::corridor()}, test::in_steps());
  race.results[0].done = false;
  EXPECT_EQ(action_error_lines(race), "");
}

TEST(ActionErrorLines, ShortenALongCommand) {
  const Race race =
      hold_race({player("program:python3 /home/somebody/mice/robot.py", clumsy)}, {test::corridor()}, test::in_steps());
  EXPECT_THAT(action_error_lines(race), HasSubstr("\n  ... /home/somebody/mice/robot.py: 2 blocked"));
}

TEST(ActionErrorFields, StandWhereAnyIsNotZero) {
  const Race race = hold_race({player("a", clumsy), player("b", solution), player("c", {Action::step(0, 1)})},
                              {test::corridor()}, test::in_steps());
  const auto json = nlohmann::json::parse(json_of(race, {}));
  for (const auto& mouse : json.at("groups").at(0).at("mice")) {
    const auto& result = mouse.at("results").at(0);
    if (mouse.at("name") == "b") {
      for (const char* field : {"blocked_steps", "void_rotations", "cut_movements", "idle_resets"})
        EXPECT_FALSE(result.contains(field));
      continue;
    }
    const int others = mouse.at("name") == "a" ? 1 : 0;
    EXPECT_EQ(result.at("blocked_steps"), others + 1);
    EXPECT_EQ(result.at("void_rotations"), others);
    EXPECT_EQ(result.at("cut_movements"), others);
    EXPECT_EQ(result.at("idle_resets"), others);
  }
}

TEST(ActionErrorFields, CountByTheRulesOfTheRace) {
  Rules rules;
  rules.stride = 2;
  const Race race = hold_race({player("a", solution)}, {test::corridor()}, test::in_steps(rules));
  EXPECT_EQ(figures_of<StepsFigures>(race.results[0]).cut_movements.value_or(0), 4);
  EXPECT_EQ(figures_of<StepsFigures>(race.results[0]).first_action_error, 1);
}

}  // namespace
}  // namespace labmouse
