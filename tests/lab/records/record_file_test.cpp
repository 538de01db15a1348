#include "labmouse/lab/records/record_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "labmouse/contest/script.hpp"
#include "tests/lab/records/record_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::changed;
using test::problem;
using test::ProblemAt;
using test::read;
using test::recorded;
using test::Says;
using test::SaysAt;
using ::testing::HasSubstr;

std::string disagreement(const std::string& text) {
  const RecordFile file = read(text);
  return file.maze ? replay(file, *file.maze).disagreement : "not read";
}

/// The first lines of a text.
std::string head(const std::string& text, int lines) {
  std::size_t end = 0;
  while (lines-- > 0) end = text.find('\n', end) + 1;
  return text.substr(0, end);
}

TEST(Record, ReadsAsItWasWritten) {
  for (const char* mouse : {"flood:stride=2", "random", "certify", "wall-right"}) {
    const RecordFile written = recorded(mouse, test::loop(), 18446744073709551615U);
    const RecordFile file = read(write_record(written));
    EXPECT_EQ(file.run, written.run);
    EXPECT_EQ(file.maze, written.maze);
    EXPECT_EQ(file.maze_name, "loop");
    EXPECT_EQ(file.mouse, mouse);
    EXPECT_EQ(file.seed, written.seed);
    EXPECT_EQ(file.rules, written.rules);
    EXPECT_TRUE(file.ended);
  }
}

TEST(Record, SaysWhatTheMouseIsAndWhatRanIt) {
  RecordFile written = recorded("fast=flood:stride=2");
  EXPECT_EQ(read(write_record(written)).mouse, "fast");
  EXPECT_EQ(read(write_record(written)).spec, "flood:stride=2");
  EXPECT_EQ(read(write_record(written)).interpreter, "");
  written.interpreter = "/usr/bin/python3 3.11.2";
  EXPECT_EQ(read(write_record(written)).interpreter, written.interpreter);
  EXPECT_EQ(read(write_record(recorded("flood"))).spec, "");
  EXPECT_THAT(problem(changed(write_record(written), "\"spec\":\"flood:stride=2\"", "\"spec\":2")),
              ProblemAt(1, 1, "mouse.spec", "string"));
}

TEST(Record, ReplaysToItself) {
  for (const auto& maze : {test::loop(), test::corridor(), test::without_route()})
    for (const char* mouse : {"flood", "random", "oracle", "visit-counter"}) {
      const RecordFile file = read(write_record(recorded(mouse, maze)));
      const ReplayResult again = replay(file, *file.maze);
      EXPECT_EQ(again.disagreement, "") << mouse << " in " << maze.name;
      EXPECT_EQ(again.run, file.run);
    }
}

TEST(Record, KeepsAStartHeadingThatNoDrawingHolds) {
  NamedMaze maze = test::loop();
  maze.maze = maze.maze.with_start({4, 3}, Heading::west);
  EXPECT_EQ(read(write_record(recorded("flood", maze))).maze, maze.maze);
}

TEST(Record, KeepsActionsThatNoMouseShouldTake) {
  const NamedMaze maze = test::loop();
  RecordFile file = recorded("flood", maze);
  Script script(maze.maze.size(), {Action::step(45, 1000), Action::step(-180, -7), Action::reset()});
  file.run = run(maze.maze, Rules(), script);
  const std::string text = write_record(file);
  EXPECT_EQ(read(text).run, file.run);
  EXPECT_EQ(disagreement(text), "");
}

/// A record that ends with these counts, as JSON.
std::string counted(const std::string& counts) {
  const std::string text = write_record(recorded("flood"));
  return text.substr(0, text.size() - 2) + ",\"counts\":" + counts + "}\n";
}

TEST(Record, KeepsWhatTheMouseCounted) {
  const RecordFile written = recorded("visit-counter");
  ASSERT_FALSE(written.run.counts.empty());
  EXPECT_EQ(read(write_record(written)).run, written.run);
  RecordFile file = recorded("flood");
  file.run.counts = {{"a \"name\"", -3}, {"nodes", std::int64_t{1} << 53U}, {"\u00e4", -(std::int64_t{1} << 53U)}};
  EXPECT_EQ(read(write_record(file)).run.counts, file.run.counts);
}

TEST(Record, SaysNothingOfCountsWhereThereAreNone) {
  EXPECT_EQ(write_record(recorded("flood")).find("counts"), std::string::npos);
  EXPECT_TRUE(read(counted("{}")).run.counts.empty());
}

TEST(Record, CountsOutOfBoundsAreRefused) {
  const auto named = [](std::size_t bytes) { return counted("{\"" + std::string(bytes, 'n') + "\":1}"); };
  EXPECT_EQ(read(named(64)).run.counts.size(), 1U);
  for (const auto& text : {named(0), named(65)}) EXPECT_THAT(problem(text).reason, HasSubstr("1 to 64 bytes"));
  for (const char* value : {"9007199254740993", "-9007199254740993", "18446744073709551615", "99999999999999999999999",
                            "1.5", "1e3", "\"1\"", "null", "true", "[1]", "{}"})
    EXPECT_THAT(problem(counted("{\"nodes\":" + std::string(value) + "}")).reason, HasSubstr("whole number")) << value;
  for (const char* counts : {"[]", "[1]", "3", "null", "\"nodes\""})
    EXPECT_THAT(problem(counted(counts)).reason, HasSubstr("not an object")) << counts;
}

TEST(Record, TooManyCountsAreRefused) {
  const auto names = [](int count) {
    std::string counts;
    for (int i = 0; i < count; ++i) counts += (i > 0 ? ",\"n" : "\"n") + std::to_string(i) + "\":1";
    return counted("{" + counts + "}");
  };
  EXPECT_EQ(read(names(64)).run.counts.size(), 64U);
  EXPECT_THAT(problem(names(65)).reason, HasSubstr("more than 64"));
}

TEST(Record, CountsTakeNoPartInAReplay) {
  const RecordFile file = read(counted("{\"nodes expanded\":7}"));
  const ReplayResult again = replay(file, *file.maze);
  EXPECT_EQ(again.disagreement, "");
  EXPECT_EQ(again.run.counts, (std::vector<Count>{{"nodes expanded", 7}}));
}

TEST(CountsLine, NamesEachCountFitToBeShown) {
  RecordFile file = recorded("flood");
  EXPECT_EQ(counts_line(file), "");
  file.run.counts = {{"nodes\nexpanded", 141}, {"found", 3}};
  EXPECT_EQ(counts_line(file), "nodes expanded 141, found 3");
}

TEST(Record, HasALineForEachStepBesidesHeaderAndEnd) {
  const RecordFile file = recorded("flood");
  const std::string text = write_record(file);
  EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')), file.run.steps.size() + 2);
}

TEST(Record, CutAfterAnyStepStillReadsAndReplays) {
  const RecordFile whole = recorded("flood");
  for (std::size_t steps = 0; steps <= whole.run.steps.size(); ++steps) {
    const RecordFile file = read(head(write_record(whole), static_cast<int>(steps) + 1));
    EXPECT_FALSE(file.ended);
    EXPECT_EQ(file.run.steps.size(), steps);
    EXPECT_EQ(replay(file, *file.maze).disagreement, "") << steps;
  }
}

TEST(Record, CutWithinALineBreaksOffBeforeIt) {
  const std::string text = write_record(recorded("flood"));
  const RecordFile file = read(head(text, 3).substr(0, head(text, 3).size() - 5));
  EXPECT_FALSE(file.ended);
  EXPECT_EQ(file.run.steps.size(), 1U);
}

TEST(Record, WithADamagedLineIsRefusedWithItsNumber) {
  const std::string text = write_record(recorded("flood"));
  const std::string lines = head(text, 3);
  const Problem found = problem(lines.substr(0, lines.size() - 5) + "\n" + text.substr(lines.size()));
  EXPECT_EQ(found.line, 3);
  EXPECT_THAT(found.reason, HasSubstr("JSON"));
}

TEST(Record, CutAtAnyByteNeverCrashes) {
  const std::string text = write_record(recorded("oracle", test::corridor()));
  for (std::size_t bytes = 0; bytes < text.size(); ++bytes) read_record(text.substr(0, bytes));
}

TEST(Record, RubbishIsRefused) {
  EXPECT_THAT(problem(""), ProblemAt(0, 0, "empty"));
  EXPECT_EQ(problem("rubbish\n").line, 1);
  for (const char* bad :
       {"\x00\xff\xfe", "[]", "3", "null", "\"record\"", "{}", "{\"format\":1}", "{\"format\":\"1\"}",
        "{\"format\":1,\"maze\":3,\"mouse\":3}", "{\"format\":1,\"maze\":{},\"mouse\":{\"name\":\"x\"}}"})
    problem(bad);
}

TEST(Record, OfAnotherFormatIsRefused) {
  EXPECT_THAT(problem(changed(write_record(recorded("flood")), "\"format\":1", "\"format\":2")).reason,
              HasSubstr("format"));
}

TEST(Record, OfAnotherProgramIsRefused) {
  problem(changed(write_record(recorded("flood")), "\"labmouse\":\"record\"", "\"labmouse\":\"recipe\""));
}

TEST(Record, CellsOutOfRangeAreRefused) {
  const std::string text = write_record(recorded("flood"));
  for (const char* cell : {"[-1,0]", "[0,64]", "[0,99999999999]", "[0.5,0]", "[0]", "[0,0,0]", "null", "\"0,0\""})
    problem(changed(text, "\"cell\":[0,0]", "\"cell\":" + std::string(cell)));
}

TEST(Record, AStartOrAGoalOutsideIsRefused) {
  const std::string text = write_record(recorded("flood"));
  EXPECT_EQ(problem(changed(text, "\"start\":[0,0]", "\"start\":[0,40]")).line, 1);
  EXPECT_EQ(problem(changed(text, "\"goals\":[[2,2]]", "\"goals\":[[2,40]]")).line, 1);
  EXPECT_EQ(problem(changed(text, "\"goals\":[[2,2]]", "\"goals\":[]")).line, 1);
}

TEST(Record, NumbersOutOfRangeAreRefused) {
  const std::string text = write_record(recorded("certify"));
  problem(changed(text, "\"budget\":1000", "\"budget\":0"));
  problem(changed(text, "\"stride\":3", "\"stride\":1000000"));
  problem(changed(text, "\"search_factor\":30", "\"search_factor\":0"));
  problem(changed(text, "\"reading\":[0,", "\"reading\":[-1,"));
  problem(changed(text, "\"reading\":[0,", "\"reading\":[99999999999999999999,"));
}

TEST(Record, AMissingStepIsRefused) {
  const std::string text = write_record(recorded("flood"));
  const std::string missing = head(text, 2) + text.substr(head(text, 3).size());
  EXPECT_EQ(problem(missing).line, 3);
}

TEST(Record, LinesBehindTheEndAreRefused) {
  const std::string text = write_record(recorded("flood"));
  problem(text + "{\"outcome\":\"finished\",\"cell\":[0,0],\"heading\":\"north\"}\n");
}

TEST(Record, UnknownWordsAreRefused) {
  const std::string text = write_record(recorded("flood"));
  problem(changed(text, "\"heading\":\"north\"", "\"heading\":\"up\""));
  problem(changed(text, "\"run\":\"search\"", "\"run\":\"walk\""));
  problem(changed(text, "\"outcome\":\"finished\"", "\"outcome\":\"won\""));
  problem(changed(text, "\"action\":[0,", "\"action\":[\"left\","));
  problem(changed(text, "\"blocked\":false", "\"blocked\":0"));
}

TEST(Replay, RefusesAnotherMaze) {
  const RecordFile file = read(write_record(recorded("flood")));
  const Maze open(MazeDraft(file.maze->size(), MazeDraft::Inside::open));
  EXPECT_THAT(replay(file, open).disagreement, SaysAt("step 1", "(0,0)"));
}

TEST(Replay, RefusesAMazeOfAnotherSize) {
  const RecordFile file = read(write_record(recorded("flood")));
  EXPECT_NE(replay(file, test::corridor().maze).disagreement, "");
  EXPECT_NE(replay(file, Maze(MazeDraft({1, 1}, MazeDraft::Inside::open))).disagreement, "");
}

TEST(Replay, RefusesAChangedReadingActionOrFlag) {
  const std::string text = write_record(recorded("flood"));
  EXPECT_THAT(disagreement(changed(text, "\"reading\":[0,4,0]", "\"reading\":[0,2,0]")), HasSubstr("step 1"));
  EXPECT_THAT(disagreement(changed(text, "\"blocked\":false", "\"blocked\":true")), HasSubstr("step 1"));
  EXPECT_NE(disagreement(changed(text, "\"action\":[0,", "\"action\":[90,")), "");
}

TEST(Replay, RefusesAnotherOutcomeOrEnd) {
  const std::string text = write_record(recorded("flood"));
  EXPECT_THAT(disagreement(changed(text, "\"outcome\":\"finished\"", "\"outcome\":\"never reset\"")),
              HasSubstr("never reset"));
}

TEST(Replay, RefusesStepsBehindTheContestsEnd) {
  RecordFile file = recorded("flood");
  StepRecord more = file.run.steps.back();
  ++more.step;
  file.run.steps.push_back(more);
  EXPECT_THAT(disagreement(write_record(file)), Says("step " + std::to_string(file.run.steps.size()), "ended"));
}

TEST(Replay, RefusesARecordThatEndsTooEarly) {
  RecordFile file = recorded("flood");
  file.run.steps.pop_back();
  EXPECT_NE(disagreement(write_record(file)), "");
}

TEST(Replay, RefusesAnEndWithoutAContest) {
  const std::string text = write_record(recorded("flood"));
  const std::string end = text.substr(text.rfind('\n', text.size() - 2) + 1);
  EXPECT_THAT(disagreement(head(text, 1) + end), HasSubstr("after step 0"));
}

TEST(Record, AForfeitAtTheEndNeedsAStepThatForfeits) {
  const std::string text = write_record(recorded("flood"));
  EXPECT_THAT(problem(changed(text, "\"outcome\":\"finished\"", "\"outcome\":\"forfeit\"")).reason,
              HasSubstr("forfeit"));
}

TEST(Record, AForfeitMayHaveAReasonOfAnEarlierVersion) {
  RecordFile file = recorded("flood");
  file.run.steps.back().action = Action::forfeit(ForfeitReason::no_route);
  file.run.outcome = Outcome::forfeit;
  const ReadRecordResult read =
      read_record(changed(write_record(file), "\"forfeit: no route\"", "\"forfeit: no way\""));
  ASSERT_TRUE(read.file);
  EXPECT_EQ(read.file->run.steps.back().action, Action::forfeit(ForfeitReason::no_route));
}

TEST(Record, AWrongSeedIsRefused) {
  const std::string text = write_record(recorded("flood"));
  EXPECT_THAT(problem(changed(text, "\"seed\":", "\"seed\":-")).reason, HasSubstr("'seed'"));
}

}  // namespace
}  // namespace labmouse
