#include "labmouse/lab/drive_record_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/lab/drive_record_fixture.hpp"

namespace labmouse {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using test::driven;

DriveRecordFile read(const std::string& text) {
  ReadDriveRecordResult result = read_drive_record(text);
  EXPECT_TRUE(result.file) << (result.problems.empty() ? "" : result.problems.front().reason);
  return std::move(*result.file);
}

Problem problem(const std::string& text) {
  const ReadDriveRecordResult result = read_drive_record(text);
  EXPECT_FALSE(result.file);
  return result.problems.empty() ? Problem() : result.problems.front();
}

std::string changed(std::string text, const std::string& old, const std::string& now) {
  const auto place = text.find(old);
  EXPECT_NE(place, std::string::npos) << old;
  return place == std::string::npos ? text : text.replace(place, old.size(), now);
}

const std::string& good() {
  static const std::string text = write_drive_record(driven("certify"));
  return text;
}

std::string disagreement(const std::string& old, const std::string& now) { return replay(read(changed(good(), old, now))); }

TEST(DriveRecordFile, IsReadAsItWasWritten) {
  for (const char* robot : {"mm2021", "classic", "half"})
    for (const char* mouse : {"flood", "certify"}) {
      const DriveRecordFile written = driven(mouse, test::ring(), robot, "thirtieth");
      const DriveRecordFile file = read(write_drive_record(written));
      EXPECT_EQ(file.record, written.record);
      EXPECT_EQ(file.maze, written.maze);
      EXPECT_EQ(file.maze_name, "ring");
      EXPECT_EQ(file.mouse, mouse);
      EXPECT_EQ(file.model->robot.name, robot);
      EXPECT_EQ(file.model->tables.hash, written.model->tables.hash);
      EXPECT_EQ(file.model->search, written.model->search);
      EXPECT_EQ(file.tables_hash, written.model->tables.hash);
      EXPECT_EQ(file.rules.name, "thirtieth");
      EXPECT_EQ(file.rules.maze_time_divisor, 30);
      EXPECT_EQ(file.rules.time_limit, written.rules.time_limit);
      EXPECT_EQ(file.recorded_score, score(written.record, written.rules).value());
      EXPECT_TRUE(file.ended);
      EXPECT_EQ(replay(file), "");
    }
}

TEST(DriveRecordFile, SaysOnItsFirstLineWhatItIs) {
  EXPECT_TRUE(is_drive_record(good()));
  EXPECT_FALSE(is_drive_record("{\"labmouse\":\"record\"}\n"));
  EXPECT_FALSE(is_drive_record("no JSON"));
}

TEST(DriveRecordFile, MayBreakOff) {
  const std::string whole = good();
  for (std::size_t end = whole.find('\n') + 1; end < whole.rfind("{\"outcome"); end += 97) {
    SCOPED_TRACE(end);
    const DriveRecordFile file = read(whole.substr(0, end));
    EXPECT_FALSE(file.ended);
    EXPECT_EQ(replay(file), "");
  }
}

TEST(DriveRecordFile, ThatIsNoneIsRefusedWithItsLine) {
  EXPECT_EQ(problem("").reason, "the record is empty");
  EXPECT_EQ(problem("{").reason, "the line is not JSON");
  EXPECT_EQ(problem(changed(good(), "drive record", "record")).reason, "the line is not the header of a record in seconds");
  EXPECT_EQ(problem(changed(good(), "\"format\":1", "\"format\":2")).reason,
            "the line has a format other than 1, which this version does not know");
  EXPECT_EQ(problem(changed(good(), "\"robot\":{\"name\"", "\"robot\":{\"nome\"")).reason, "'robot.name' is missing");
  EXPECT_EQ(problem(changed(good(), "\"straight.speed\":1500", "\"straight.speed\":-5")).reason,
            "'robot': 'straight.speed' is -5; it must be 100 to 20000 mm/s");
  EXPECT_EQ(problem(changed(good(), "\"straight.speed\"", "\"straight speed\"")).reason,
            "'robot.parameters' has a key or a value that no robot has");
  EXPECT_EQ(problem(changed(good(), "\"most_runs\":5", "\"most_runs\":0")).reason, "'rules.most_runs' is outside of 1 to 1000");
  EXPECT_EQ(problem(good() + good()).reason, "the line stands behind the end of the record");
  EXPECT_EQ(problem(changed(good(), "\"run\":\"search\"", "\"run\":\"stroll\"")),
            (Problem{2, 1, "the line has a run that is none of search, home, fast"}));
  EXPECT_EQ(problem(changed(good(), "{\"move\":[0,1]", "{\"move\":[0,2]")), (Problem{3, 1, "'move' is outside of 0 to 1"}));
  EXPECT_THAT(problem(changed(good(), "{\"move\"", "{\"love\"")).reason, StartsWith("the line is none of a record in seconds"));
  EXPECT_EQ(problem(changed(good(), "\"piece\":\"R90\"", "\"piece\":\"R91\"")).reason,
            "the line has a piece that is no straight, and no turn that this robot makes there at that speed");
  EXPECT_EQ(problem(changed(good(), "\"outcome\":\"finished\"", "\"outcome\":\"lost\"")).reason,
            "'outcome' is 'lost', which this version does not know");
}

TEST(DriveRecordFile, WithWallsOfAnotherMazeIsRefused) {
  EXPECT_EQ(problem(changed(good(), "{\"wall\":[0,0,\"north\"]", "{\"wall\":[0,2,\"north\"]")).reason,
            "the line has a wall that is no inner one, named by its north or east side");
  EXPECT_EQ(problem(changed(good(), "\"north\":[\"1\",\"0\",\"0\"]", "\"north\":[\"1\",\"0\",\"1\"]")).reason,
            "'open' has walls that the maze does not have");
  EXPECT_EQ(problem(changed(good(), "\"north\":[\"1\",\"0\",\"0\"]", "\"north\":[\"1\",\"0\"]")).reason,
            "'open' has 2 rows where the maze has 3");
}

TEST(DriveRecordFile, ThatDoesNotFitItsMazeIsToldOf) {
  DriveRecordFile other = read(good());
  ++other.tables_hash;
  EXPECT_THAT(replay(other), StartsWith("the tables of its robot have the hash "));
  EXPECT_THAT(disagreement("\"until\":300000", "\"until\":300001"),
              StartsWith("run 1 (search): move 1: recorded from (0,0) heading north to (0,1) heading north, 0.000000 s to 0.300001 s; "
                         "played from (0,0) heading north to (0,1) heading north, 0.000000 s to 0.300000 s"));
  EXPECT_THAT(disagreement("\"known\":null", "\"known\":5"), StartsWith("run 1 (search): recorded are a known route of 0.000005 s"));
  EXPECT_THAT(disagreement("\"north\":[\"1\",\"0\",\"0\"]", "\"north\":[\"0\",\"0\",\"0\"]"),
              StartsWith("run 1 (search): recorded are 0 open and 1 closed walls at its beginning; played, 1 and 1"));
  EXPECT_THAT(disagreement("\"gate_out\":300000", "\"gate_out\":300001"), HasSubstr("recorded to leave the start at 0.300001 s"));
  EXPECT_THAT(disagreement("\"open\":true,\"time\":0}", "\"open\":false,\"time\":0}"), StartsWith("wall 1: recorded the north side of (0,0) closed"));
  EXPECT_THAT(disagreement("\"score\":{\"value\":", "\"score\":{\"value\":1"), StartsWith("recorded is a score of "));
}

TEST(DriveRecordFile, WithAWrongRouteIsToldOf) {
  EXPECT_THAT(disagreement("\"piece\":\"S2\"", "\"piece\":\"S4\""), HasSubstr("it does not lead to where it is said to end"));
  EXPECT_THAT(disagreement("{\"piece\":\"R90\"", "{\"piece\":\"L90\""), HasSubstr("it does not lead to where it is said to end"));
}

TEST(DriveRecordFile, HasASummary) {
  const DriveRecordFile file = driven("flood");
  const std::string summary = summary_of(file);
  EXPECT_THAT(summary, StartsWith("run           begin s     end s    gates   centre    known    hoped\n  1  search     0.000 "));
  EXPECT_THAT(summary, HasSubstr("\nflood in ring, mm2021, all-japan: "));
  EXPECT_THAT(summary, HasSubstr(" s gate to gate in run "));
}

}  // namespace
}  // namespace labmouse
