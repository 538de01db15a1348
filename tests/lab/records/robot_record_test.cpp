// Records that a robot wrote: much may be missing, and serial lines have habits of their own.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>

#include "tests/lab/records/record_fixture.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::changed;
using test::problem;
using test::ProblemAt;
using test::read;
using test::recorded;
using test::Says;
using test::SaysAt;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string header = "{\"labmouse\":\"record\",\"format\":1}\n";
/// What a robot prints in the corridor of these tests: to the goal in three steps, and once more in three.
const std::string walk =
    "{\"reading\":[0,0,3],\"action\":[90,3]}\n"
    "{\"reading\":[1,0,0],\"action\":[-90,1]}\n"
    "{\"reading\":[3,0,0],\"action\":[-90,3]}\n"
    "{\"reading\":[0,0,0],\"action\":\"reset\"}\n"
    "{\"reading\":[0,0,3],\"action\":[90,3]}\n"
    "{\"reading\":[1,0,0],\"action\":[-90,1]}\n"
    "{\"reading\":[3,0,0],\"action\":[-90,3]}\n";
const std::string end = "{\"outcome\":\"finished\"}\n";

/// Two rows, with the goal above the start and the only way at the far end.
Maze two_rows() {
  return test::drawn(R"(
    o---o---o---o---o
    | G             |
    o---o---o---o   o
    | S             |
    o---o---o---o---o
  )");
}

ReplayResult played(const std::string& text, const Maze& maze = two_rows()) { return replay(read(text), maze); }
std::string disagreement(const std::string& text) { return played(text).disagreement; }
/// The walk with another second step.
std::string with_step(const std::string& fields) {
  return changed(header + walk + end, "{\"reading\":[1,0,0],", "{" + fields + ",");
}
/// A record whose header has these fields as well.
std::string with_header(const std::string& fields) { return changed(header, "1}", "1," + fields + "}"); }

TEST(RobotRecord, NeedsNoMoreThanActions) {
  const RecordFile file = read(header + "{\"action\":[90,3]}\n{\"action\":[-90,1]}\n{\"action\":[-90,3]}\n");
  EXPECT_EQ(file.maze, std::nullopt);
  EXPECT_EQ(file.maze_name, "maze");
  EXPECT_EQ(file.mouse, "robot");
  EXPECT_EQ(file.rules, Rules());
  EXPECT_FALSE(file.ended);
  ASSERT_EQ(file.run.steps.size(), 3U);
  EXPECT_EQ(file.run.steps[2].step, 3);
  EXPECT_EQ(file.given, std::vector<GivenFields>(3, GivenFields{false, false, false, false, false}));
  EXPECT_EQ(replay(file, two_rows()).disagreement, "");
}

TEST(RobotRecord, IsFilledByPlayingIt) {
  const ReplayResult result = played(header + walk + end);
  EXPECT_EQ(result.disagreement, "");
  ASSERT_EQ(result.run.steps.size(), 7U);
  const Pose corner = {{3, 0}, Heading::east};
  EXPECT_EQ(result.run.steps[1], (StepRecord{Run::search_run, 2, corner, {1, 0, 0}, Action::step(-90, 1), false}));
  EXPECT_EQ(result.run.steps[6].run, Run::speed);
  EXPECT_EQ(result.run.outcome, Outcome::finished);
  EXPECT_EQ(result.run.end, (Pose{{0, 1}, Heading::west}));
}

TEST(RobotRecord, OfAMouseIsTheSameRunWithoutWhatFollows) {
  const RecordFile whole = recorded("ariadne", test::loop());
  std::string text = header;
  for (const StepRecord& step : whole.run.steps)
    text += step.action.kind == Action::Kind::reset
                ? "{\"action\":\"reset\"}\n"
                : fmt::format("{{\"action\":[{},{}]}}\n", step.action.rotation, step.action.movement);
  EXPECT_EQ(played(text, *whole.maze).run, whole.run);
}

TEST(RobotRecord, IsRefusedWithoutAnAction) {
  EXPECT_THAT(problem(header + "{\"reading\":[0,0,3]}\n"), ProblemAt(2, 1, "no action"));
}

TEST(RobotRecord, ReadsWhatItGivesAsStrictlyAsEver) {
  for (const char* bad :
       {"\"cell\":null", "\"cell\":[0]", "\"heading\":\"up\"", "\"run\":\"walk\"", "\"blocked\":0", "\"reading\":[1,2]",
        "\"reading\":[1,2,3,4]", "\"reading\":[1,2,null]", "\"reading\":[1,2,65]", "\"step\":2"})
    EXPECT_EQ(problem(header + "{\"action\":[0,1]," + bad + "}\n").line, 2) << bad;
  for (const char* bad : {"\"maze\":3", "\"maze\":{\"name\":3}", "\"maze\":{\"drawing\":[]}", "\"mouse\":\"robot\"",
                          "\"mouse\":{\"name\":null}", "\"rules\":{\"stride\":0}", "\"rules\":[]", "\"seed\":-1"})
    EXPECT_EQ(problem(with_header(bad)).line, 1) << bad;
}

TEST(RobotRecord, OfAMazeWithPlacesButNoDrawingIsRefused) {
  for (const char* place : {"\"start\":[0,0]", "\"heading\":\"east\"", "\"goals\":[[7,7]]"})
    EXPECT_THAT(problem(with_header("\"maze\":{" + std::string(place) + "}")).reason, HasSubstr("no drawing"));
  EXPECT_EQ(read(with_header("\"maze\":{\"name\":\"hall\"}")).maze_name, "hall");
}

TEST(RobotRecord, MayLeaveStartAndGoalsToTheDrawing) {
  const auto with = [](const std::string& more) {
    return *read(with_header(R"("maze":{"drawing":["o---o---o","| G   S |","o---o---o"])" + more + "}")).maze;
  };
  EXPECT_EQ(with("").start(), (Cell{1, 0}));
  EXPECT_EQ(with("").start_heading(), Heading::north);
  EXPECT_TRUE(with("").is_goal({0, 0}));
  EXPECT_FALSE(with("").is_goal({1, 0}));
  EXPECT_EQ(with(",\"heading\":\"west\""), with("").with_start({1, 0}, Heading::west));
  EXPECT_EQ(with(",\"start\":[0,0]").start(), (Cell{0, 0}));
  EXPECT_TRUE(with(",\"goals\":[[1,0]]").is_goal({1, 0}));
}

TEST(RobotRecord, MayGiveSomeOfTheRules) {
  const Rules rules = read(with_header("\"rules\":{\"stride\":1}")).rules;
  EXPECT_EQ(rules.stride, 1);
  EXPECT_EQ(rules.budget, Rules().budget);
  EXPECT_EQ(rules.search_factor, Rules().search_factor);
  EXPECT_EQ(read(with_header("\"rules\":{\"budget\":5}")).rules.budget, 5);
}

TEST(RobotRecord, IsComparedInEachFieldThatItGives) {
  const auto told = [](const std::string& field) { return disagreement(with_step(field)); };
  for (const char* good : {"\"run\":\"search\"", "\"step\":2", "\"cell\":[3,0]", "\"heading\":\"east\"",
                           "\"reading\":[1,0,0]", "\"blocked\":false"})
    EXPECT_EQ(told(good), "") << good;
  EXPECT_THAT(told("\"run\":\"speed\""), Says("speed run", "search", "(3,0)"));
  EXPECT_THAT(told("\"cell\":[2,0]"), Says("at (2,0)", "at (3,0) heading east", "reading 1 0 0"));
  EXPECT_THAT(told("\"heading\":\"west\""), SaysAt("step 2", "heading west", "at (3,0) heading east"));
  EXPECT_THAT(told("\"reading\":[1,0,1]"), SaysAt("step 2", "reading 1 0 1", "at (3,0) heading east"));
  EXPECT_THAT(told("\"blocked\":true"),
              Says("recorded blocked", "at (3,0) heading east", "reading 1 0 0", "not blocked"));
}

TEST(RobotRecord, NamesTheWallThatAReadingContradicts) {
  const auto told = [](const std::string& reading) { return disagreement(with_step("\"reading\":" + reading)); };
  EXPECT_THAT(told("[0,0,0]"), HasSubstr("no wall north of (3,0)"));
  EXPECT_THAT(told("[1,2,0]"), HasSubstr("a wall east of (3,0)"));
  EXPECT_THAT(told("[2,0,1]"), Says("a wall north of (3,1)", "a wall south of (3,0)"));
  const std::string first = disagreement(changed(header + walk, "[0,0,3]", "[0,0,4]"));
  EXPECT_THAT(first, HasSubstr("a wall east of (3,0)"));
}

TEST(RobotRecord, SpeaksOfRunAndBlocksOnlyWhereTheyDiffer) {
  EXPECT_THAT(disagreement(with_step("\"run\":\"search\",\"blocked\":false,\"reading\":[1,1,0]")),
              AllOf(SaysAt("step 2", "reading 1 1 0", "at (3,0) heading east", "reading 1 0 0", "a wall east of (3,0)"),
                    Not(HasSubstr("search")), Not(HasSubstr("blocked"))));
}

TEST(RobotRecord, NamesNoWallWhereItStoodElsewhere) {
  EXPECT_THAT(disagreement(with_step("\"cell\":[2,0],\"reading\":[0,1,0]")), Not(HasSubstr("wall")));
  EXPECT_THAT(disagreement(with_step("\"heading\":\"north\",\"reading\":[0,1,0]")), Not(HasSubstr("wall")));
  EXPECT_THAT(disagreement(with_step("\"cell\":[3,0],\"heading\":\"east\",\"reading\":[0,0,0]")),
              Says("at (3,0) heading east", "reading 1 0 0", "no wall north of (3,0)"));
}

TEST(RobotRecord, EndsWithAsMuchAsItGives) {
  const auto told = [](const std::string& last) { return disagreement(header + walk + last); };
  for (const char* good : {"", R"({"outcome":"finished","cell":[0,1]})", R"({"outcome":"finished","heading":"west"})"})
    EXPECT_EQ(told(good), "");
  EXPECT_THAT(told(R"({"outcome":"never reset"})"), Says("'never reset'", "'finished' at (0,1) heading west"));
  EXPECT_THAT(told(R"({"outcome":"finished","cell":[0,0]})"),
              Says("'finished' at (0,0)", "'finished' at (0,1) heading west"));
  EXPECT_THAT(told(R"({"outcome":"finished","heading":"east"})"),
              Says("'finished' heading east", "'finished' at (0,1) heading west"));
}

TEST(RobotRecord, SaysHowTheContestEndedBeforeItsLastStep) {
  EXPECT_THAT(disagreement(header + walk + "{\"action\":[0,1]}\n"), Says("step 8", "ended", "(finished)"));
  const std::string short_of_time = with_header("\"rules\":{\"budget\":2}");
  EXPECT_THAT(disagreement(short_of_time + walk), Says("step 3", "ended", "(out of steps)"));
}

TEST(RobotRecord, MayComeOverASerialLine) {
  std::string text = "\xEF\xBB\xBF\r\n";
  for (const char letter : header + walk + end)
    text += letter == '\n' ? std::string("\r\n\r\n") : std::string(1, letter);
  EXPECT_EQ(disagreement(text), "");
  EXPECT_EQ(read(text).run, read(header + walk + end).run);
  EXPECT_TRUE(read(text).ended);
  EXPECT_EQ(disagreement("\xEF\xBB\xBF" + header + walk + end), "");
}

TEST(RobotRecord, BreaksOffWhereItsLastLineWasCut) {
  const std::string text = header + walk + end;
  for (std::size_t bytes = header.size(); bytes < text.size(); ++bytes) {
    const RecordFile file = read(text.substr(0, bytes));
    // A line that lacks no more than its end is whole.
    const std::string next = text.substr(0, bytes + 1);
    const auto lines = std::count(next.begin(), next.end(), '\n');
    EXPECT_EQ(file.run.steps.size(), static_cast<std::size_t>(std::min<std::ptrdiff_t>(lines - 1, 7))) << bytes;
    EXPECT_EQ(replay(file, two_rows()).disagreement, "") << bytes;
  }
}

TEST(RobotRecord, OnlyALastLineWithoutItsEndCountsAsCut) {
  EXPECT_THAT(problem(header + "{\"action\":[0,\n"), ProblemAt(2, 14, "JSON"));
  EXPECT_EQ(problem(header + "{\"action\":[0,\n" + walk).line, 2);
  EXPECT_EQ(problem(header + walk + end + "{\"act").line, 10);
  EXPECT_EQ(problem(header.substr(0, 20)).line, 1);
}

TEST(RobotRecord, HoldsOneContest) {
  const std::string named = "{\"labmouse\":1,\"action\":[0,0]}\n{\"labmouse\":1,\"outcome\":\"finished\"}\n";
  EXPECT_EQ(read(header + named).run.steps.size(), 1U);
  EXPECT_THAT(problem(header + walk + header + walk).reason, HasSubstr("second header"));
}

TEST(RobotRecord, OfTooManyStepsIsRefused) {
  if (!test::thorough) GTEST_SKIP() << "a million steps are the same step: only with LABMOUSE_PROOF";
  std::string text = header;
  for (int step = 0; step <= 1'000'000; ++step) text += "{\"action\":[0,0]}\n";
  EXPECT_THAT(problem(text).reason, Says("1000000 steps"));
}

TEST(RobotRecord, WithReasonsNeedsAMazeThatHasTheirWalls) {
  const auto reasoned = [](const std::string& candidate) {
    return header + "{\"action\":[90,1],\"reasons\":{\"candidates\":[{" + candidate +
           ",\"through\":3,\"travel\":1,\"score\":1}],\"chosen\":0,\"known\":0,\"way_here\":0,\"hope\":0,\"price\":0}}"
           "\n";
  };
  EXPECT_EQ(disagreement(reasoned(R"("wall":[0,0,"north"],"seen_from":[0,0])")), "");
  const std::string of_a_goal = reasoned(R"("goal":true,"seen_from":[1,0])");
  EXPECT_EQ(disagreement(of_a_goal), "");
  EXPECT_EQ(played(of_a_goal, Maze(MazeDraft({4, 1}, MazeDraft::Inside::open))).disagreement, "");
  for (const char* bad : {R"("wall":[3,0,"east"],"seen_from":[0,0])", R"("wall":[0,0,"north"],"seen_from":[4,0])",
                          R"("goal":true,"seen_from":[0,2])"})
    EXPECT_THAT(disagreement(reasoned(bad)), SaysAt("step 1", "reasons", "walls"));
}

TEST(CheckedLine, CountsWhatAReplayCompares) {
  EXPECT_THAT(checked_line(read(header + walk)), AllOf(Says("7 steps"), EndsWith(": 7 readings")));
  EXPECT_THAT(checked_line(read(header + walk + end)), AllOf(Says("7 steps: 7 readings"), EndsWith("outcome")));
  EXPECT_THAT(checked_line(read(header + "{\"action\":[0,0]}\n")), EndsWith("1 step: no readings"));
  const std::string all_but_reading =
      R"({"action":[0,0],"cell":[0,0],"heading":"north","run":"search","blocked":false})";
  EXPECT_THAT(checked_line(read(header + all_but_reading + "\n" + R"({"action":[0,0],"cell":[0,0]})" + "\n")),
              EndsWith("2 steps: no readings, 2 cells, 1 heading, 1 run, 1 blocked flag"));
}

TEST(CheckedLine, SaysNothingOfAWholeRecord) {
  const std::string text = write_record(recorded("flood"));
  EXPECT_EQ(checked_line(read(text)), "");
  EXPECT_EQ(checked_line(recorded("flood")), "");
  EXPECT_EQ(checked_line(read(text.substr(0, text.rfind('\n', text.size() - 2) + 1))), "");
  EXPECT_NE(checked_line(read(text.substr(0, text.rfind('\n', text.size() - 2) + 1) + "{\"outcome\":\"finished\"}")),
            "");
}

}  // namespace
}  // namespace labmouse
