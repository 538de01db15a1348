// Reasons in words.
#include "labmouse/lab/records/explanation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "labmouse/contest/script.hpp"
#include "labmouse/contest/simulator.hpp"
#include "tests/lab/drawing/drawing_samples.hpp"
#include "tests/lab/records/record_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using test::SaysAt;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

/// Through the ring to the goal in three steps, the reset in the fourth, and the same way again; without reasons.
RecordFile walk() {
  const Action north = Action::step(0, 2), east = Action::step(90, 1), south = Action::step(90, 1);
  RecordFile file;
  file.maze = ring();
  file.rules.budget = 100;
  Script script(file.maze->size(), {north, east, south, Action::reset(), north, east, south});
  file.run = run(*file.maze, file.rules, script);
  return file;
}

Candidate candidate(Wall wall, int through, double score) { return {wall, wall.cell, false, through, 1, true, score}; }

/// In the first step it looks ahead and chooses the second of three, in the third it goes into the goal, in the fourth
/// nothing is worth it.
std::vector<StepReasons> reasons() {
  std::vector<StepReasons> all(3);
  all[0].step = 1;
  all[0].reasons.candidates = {candidate({{1, 1}, Heading::east}, 100, 145),
                               candidate({{0, 2}, Heading::east}, 52, 92.125),
                               candidate({{1, 2}, Heading::east}, 53, 1)};
  all[0].reasons.candidates[2].worth = false;
  all[0].reasons.chosen = 1;
  all[0].reasons.way_here = 0;
  all[1].step = 3;
  all[1].reasons.candidates = {{{}, {1, 1}, true, 90, 1, true, 13.5}};
  all[1].reasons.chosen = 0;
  all[1].reasons.known = 90;
  all[1].reasons.way_here = 0;
  all[2].step = 4;
  all[2].reasons.candidates = {candidate({{1, 0}, Heading::east}, 96, 120),
                               candidate({{2, 0}, Heading::north}, 92, 130)};
  for (Candidate& candidate : all[2].reasons.candidates) candidate.worth = false;
  all[2].reasons.known = 90;
  all[2].reasons.hope = 92;
  all[2].reasons.price = 1.5;
  return all;
}

RecordFile explained() {
  RecordFile file = walk();
  file.run.reasons = reasons();
  return file;
}

/// What is said of the last step.
std::string end_of(const std::string& explanation) { return explanation.substr(explanation.rfind("\nstep ") + 1); }

TEST(Explanation, TellsEachChoiceAndWhyItStopped) {
  const std::string text = explanation_of(explained(), 5);
  EXPECT_THAT(text, SaysAt("T", "\ntravel: ", "score: ", "(>)", "\nT ahead: "));
  EXPECT_THAT(text, HasSubstr(R"(

step 1 at (0,0) heading north, before the goal: 3 candidates
    wall            seen from  T ahead  travel    score
  > (0,2) east      (0,2)         1.73       1     3.07
    (1,1) east      (1,1)         3.33       1     4.83
  - (1,2) east      (1,2)         1.77       1     0.03

step 3 at (1,2) heading east, before the goal: 1 candidate
    wall            seen from  T ahead  travel    score
  > goal (1,1)      (1,1)         0.00       1     0.45

step 4 at (1,1) heading south, after the goal: 2 candidates
    wall            seen from        T  travel    score
  - (2,0) north     (2,0)         3.07       1     4.33
  - (1,0) east      (1,0)         3.20       1     4.00

step 4: )"));
  EXPECT_THAT(end_of(text), SaysAt("step 4", "reset", "3 steps", "3.07 through (2,0) north", "0.05"));
}

TEST(Explanation, ShowsTheBestCandidatesAndCountsTheOthers) {
  const std::string text = explanation_of(explained(), 1);
  EXPECT_THAT(text, HasSubstr("  > (0,2) east      (0,2)         1.73       1     3.07\n    and 2 more\n"));
  EXPECT_THAT(text, HasSubstr("  - (2,0) north     (2,0)         3.07       1     4.33\n    and 1 more\n"));
  EXPECT_THAT(text, Not(HasSubstr("(1,1) east")));
}

TEST(Explanation, IsEmptyWithoutReasons) { EXPECT_EQ(explanation_of(walk(), 5), ""); }

TEST(Explanation, SaysNothingOfAheadWhereTheWholeRunCounts) {
  RecordFile file = explained();
  file.run.reasons.erase(file.run.reasons.begin(), file.run.reasons.begin() + 2);
  EXPECT_THAT(explanation_of(file, 5), Not(HasSubstr("ahead")));
  file.run.reasons[0].reasons.way_here = 0.25;
  EXPECT_THAT(explanation_of(file, 5), Says("\nT ahead: ", "less of the way"));
}

TEST(Explanation, CountsTheWayToTheGoalAsMuchAsItWasWeighed) {
  RecordFile file = explained();
  file.run.reasons[1].reasons.way_here = 0.5;
  EXPECT_THAT(explanation_of(file, 5), HasSubstr("goal (1,1)      (1,1)         1.50 "));
}

TEST(Explanation, TellsOfAResetWithoutNewReasons) {
  RecordFile file = explained();
  file.run.reasons.pop_back();
  EXPECT_THAT(end_of(explanation_of(file, 5)),
              AllOf(SaysAt("step 4", "reset without", "96 of 100 steps"), Not(HasSubstr("known run"))));
}

TEST(Explanation, TellsOfAResetAgainstTheChoice) {
  RecordFile file = explained();
  file.run.reasons.back().reasons.chosen = 0;
  EXPECT_THAT(end_of(explanation_of(file, 5)), SaysAt("step 4", "reset", "96 of 100 steps", "known run takes 3"));
}

TEST(Explanation, TellsWhereNoWallIsLeft) {
  RecordFile file = explained();
  Reasons& last = file.run.reasons.back().reasons;
  last.candidates.clear();
  last.hope = last.price = 0;
  const std::string text = explanation_of(file, 5);
  EXPECT_THAT(text, HasSubstr("0 candidates\n\nstep 4: "));
  EXPECT_THAT(end_of(text), SaysAt("step 4", "reset", "3 steps", "No unseen wall"));
}

TEST(Explanation, OfEqualHopesNamesTheNearest) {
  RecordFile file = explained();
  Candidate far = candidate({{0, 1}, Heading::north}, 92, 100);
  far.travel = 2;
  far.worth = false;
  auto& candidates = file.run.reasons.back().reasons.candidates;
  candidates.insert(candidates.begin(), far);
  EXPECT_THAT(end_of(explanation_of(file, 5)), SaysAt("step 4", "3.07 through (2,0) north"));
}

TEST(Explanation, TellsOfAStopForWantOfLoops) {
  RecordFile file = explained();
  Reasons& last = file.run.reasons.back().reasons;
  last = Reasons();
  last.ground = Ground::no_loops;
  last.known = 90;
  EXPECT_THAT(end_of(explanation_of(file, 5)), SaysAt("step 4", "reset", "without loops", "3 steps"));
}

TEST(Explanation, TellsOnceWhereItBeginsToFlood) {
  RecordFile file = explained();
  for (std::size_t i : {0U, 1U}) {
    file.run.reasons[i].reasons = Reasons();
    file.run.reasons[i].reasons.ground = Ground::flood;
    file.run.reasons[i].step = static_cast<int>(i) + 1;
  }
  const std::string text = explanation_of(file, 5);
  EXPECT_THAT(text, HasSubstr("\nstep 1 at (0,0): floods"));
  EXPECT_THAT(text, ::testing::Not(HasSubstr("step 2")));
}

TEST(Explanation, TellsOfAForfeit) {
  RecordFile file = explained();
  file.run.steps.resize(4);
  file.run.steps.back().action = Action::forfeit(ForfeitReason::no_route);
  EXPECT_THAT(end_of(explanation_of(file, 5)), SaysAt("step 4", "forfeit", "no route"));
}

TEST(Explanation, OfARecordThatBreaksOffHasNoEnd) {
  RecordFile file = explained();
  file.run.steps.resize(2);
  file.run.reasons.resize(1);
  EXPECT_THAT(explanation_of(file, 5), EndsWith("0.03\n"));
}

TEST(Explanation, OfAMouseStaysWithinEightyColumns) {
  const std::string text = explanation_of(test::recorded("ariadne", test::loop(), 1, true), 5);
  EXPECT_THAT(text, HasSubstr("\nstep 1 at (0,0) heading north"));
  EXPECT_THAT(text, HasSubstr(": reset"));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

}  // namespace
}  // namespace labmouse
