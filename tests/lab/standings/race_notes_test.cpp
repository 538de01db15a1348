#include "labmouse/lab/standings/race_notes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/standings/junit.hpp"
#include "labmouse/lab/standings/race_names.hpp"
#include "labmouse/lab/worlds/entering.hpp"
#include "tests/lab/races/race_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// Dies at once, and says in how wide a maze.
class Mourner final : public Strategy {
 public:
  explicit Mourner(Size size) : knowledge_(size), words_("died on " + std::to_string(size.width) + " columns\n") {}

  Action decide(const Sighting&) override { return Action::forfeit(ForfeitReason::ended_early); }
  const Knowledge& knowledge() const override { return knowledge_; }
  StrategyReport report() override { return {.last_words = words_}; }

 private:
  Knowledge knowledge_;
  std::string words_;
};

std::string notes_on_a_mourner_in(std::vector<NamedMaze> mazes) {
  Contestant mouse;
  mouse.name = "program:./mourner";
  const auto make = [](const Maze& maze, const Briefing&) { return std::make_unique<Mourner>(maze.size()); };
  mouse.kind = Decider{make};
  return notes_of(hold_race({mouse}, std::move(mazes), test::in_steps()));
}

/// The first in the order of names; no contest in it counts.
NamedMaze closed() { return {"a closed maze", test::without_route().maze}; }

TEST(RaceNotes, QuoteTheFirstFailureInAMazeThatCounts) {
  const std::string notes = notes_on_a_mourner_in({closed(), test::corridor(), test::loop()});
  EXPECT_THAT(notes, Says("Failures:", "forfeit (ended early) 2\n", "first in corridor: died on 4 columns\n"));
  EXPECT_THAT(notes, Not(HasSubstr("died on 2 columns")));
}

TEST(RaceNotes, NameNoFailuresInMazesThatDoNotCount) {
  EXPECT_THAT(notes_on_a_mourner_in({closed()}), AllOf(HasSubstr("a closed maze"), Not(HasSubstr("Failures"))));
}

std::string notes_on(const char* mice, const std::vector<std::string>& names) {
  std::vector<NamedMaze> mazes;
  for (const std::string& name : names) mazes.push_back({name, test::corridor().maze});
  return notes_of(hold_race(read_specs(mice).contestants, std::move(mazes), test::in_steps()));
}

TEST(RaceNotes, NameMazesThatShareTheirSeeds) {
  EXPECT_THAT(notes_on("random", {"a/x.txt", "b/x.txt", "y.txt"}), Says("a/x.txt", "b/x.txt", "seeds"));
  EXPECT_THAT(notes_on("random", {"a/x.txt", "b/y.txt"}), Not(HasSubstr("seeds")));
  EXPECT_THAT(notes_on("flood", {"a/x.txt", "b/x.txt"}), Not(HasSubstr("seeds"))) << "makes no random choices";
  EXPECT_EQ(contest_seed(1, "a/x.txt", 0), contest_seed(1, "x.txt", 0)) << "stores have contests under their seeds";
}

/// Flood in mazes of five columns, and a mourner in others.
Contestant mouse_for_five_columns() {
  Contestant mouse = test::mice("flood").front();
  mouse.name = "five";
  const auto flood = std::get<Decider>(mouse.kind).make;
  mouse.kind = Decider{[flood](const Maze& maze, const Briefing& briefing) -> std::unique_ptr<Strategy> {
    if (maze.size().width == 5) return flood(maze, briefing);
    return std::make_unique<Mourner>(maze.size());
  }};
  return mouse;
}

std::vector<NamedMaze> mazes_of_two_sizes() {
  return {{"a", test::loop().maze}, {"b", test::loop().maze}, {"c", test::loop().maze}, test::corridor(), test::hook()};
}

TEST(RaceNotes, SayWhereFailuresFollowTheSize) {
  const Race race = hold_race({mouse_for_five_columns()}, mazes_of_two_sizes(), test::in_steps());
  EXPECT_THAT(notes_of(race), Says("five finished all 3 contests in 5x5, and 0 of 2 in other sizes"));
  EXPECT_THAT(notes_of(hold_race(test::mice("flood"), mazes_of_two_sizes(), test::in_steps())),
              Not(HasSubstr("other sizes")));
}

TEST(JUnit, HasASuiteForEachRobotAndNoise) {
  std::vector<Race> races;
  for (const Entry& entry :
       enter(test::mice("flood-return"), "physical", {{"noise", "0,1"}, {"robot", "kerise"}}).entries) {
    RaceOrder order;
    order.world = entry.world;
    races.push_back(hold_race(entry.mice, {test::corridor()}, order));
  }
  EXPECT_THAT(junit_of(races, 1.0),
              Says("\"flood-return (physical, noise 0)\"", "\"flood-return (physical, noise 1)\""));
  races.pop_back();
  EXPECT_THAT(junit_of(races, 1.0), Says("\"flood-return (physical)\""));
}

TEST(RaceNames, AreTheWorldAndWhatDiffersInIt) {
  std::vector<Race> races;
  for (const auto& [world, robots] : {std::pair("seconds", "classic,half"), std::pair("steps", "")}) {
    const WorldSettings settings =
        std::string_view(robots).empty() ? WorldSettings() : WorldSettings{{"robot", robots}};
    for (const Entry& entry : enter(test::mice("flood"), world, settings).entries) {
      RaceOrder order;
      order.world = entry.world;
      races.push_back(hold_race(entry.mice, {test::corridor()}, order));
    }
  }
  EXPECT_THAT(race_names(races), ElementsAre("seconds, classic", "seconds, half", "steps"));
}

TEST(JUnit, HasATestForEachContestAndOneForTheMean) {
  const std::vector races = {
      hold_race({mouse_for_five_columns()}, {test::loop(), {"<hook>", test::hook().maze}}, test::in_steps())};
  const std::string text = junit_of(races, 1.0);
  EXPECT_THAT(text, Says("<testsuite name=\"five (steps)\" tests=\"3\" failures=\"2\" skipped=\"0\">",
                         "name=\"&lt;hook&gt;, run 1\"><failure message=\"forfeit: ended early\"/>",
                         "name=\"loop, run 1\"/>", "name=\"mean score\"><failure"));
  EXPECT_THAT(junit_of(races, std::nullopt), Says("tests=\"2\" failures=\"1\""));
}

}  // namespace
}  // namespace labmouse
