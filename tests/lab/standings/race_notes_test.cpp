#include "labmouse/lab/standings/race_notes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/lab/mice/specs.hpp"
#include "tests/lab/races/race_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// Dies at once, and says in how wide a maze.
class Mourner final : public Strategy {
 public:
  explicit Mourner(Size size) : knowledge_(size), words_("died on " + std::to_string(size.width) + " columns\n") {}

  Action decide(const Sighting&) override { return Action::forfeit(ForfeitReason::died); }
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
  EXPECT_THAT(notes, Says("Failures:", "forfeit (died) 2\n", "first in corridor: died on 4 columns\n"));
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
  EXPECT_THAT(notes_on("flood", {"a/x.txt", "b/x.txt"}), Not(HasSubstr("seeds"))) << "throws no dice";
  EXPECT_EQ(contest_seed(1, "a/x.txt", 0), contest_seed(1, "x.txt", 0)) << "stores have contests under their seeds";
}

}  // namespace
}  // namespace labmouse
