// Records of mms: read back, and given to the simulator again.
#include "labmouse/lab/records/mms_record_file.hpp"

#include <gmock/gmock.h>

#include "labmouse/lab/records/mms_record.hpp"
#include "tests/lab/mms_record_fixture.hpp"
#include "tests/lab/record_fixture.hpp"

namespace labmouse {
namespace {

using test::changed;
using test::mms_recorded;
using ::testing::HasSubstr;

const std::vector<std::string> walk = {"setColor 0 0 G", "turnRight", "moveForward", "setText 1 0 goal", "ackReset"};

MmsRecordFile read(const std::string& text) {
  ReadMmsRecordResult result = read_mms_record(text);
  if (!result.file) ADD_FAILURE() << result.problems.front().line << ": " << result.problems.front().reason;
  return result.file ? *result.file : MmsRecordFile();
}

Problem problem(const std::string& text) {
  const ReadMmsRecordResult result = read_mms_record(text);
  EXPECT_FALSE(result.file.has_value());
  return result.problems.empty() ? Problem() : result.problems.front();
}

std::string disagreement(const std::string& text) {
  return replay(read(text), [](std::size_t, const MmsHost&) {});
}

TEST(MmsRecordFile, IsReadAsItWasWritten) {
  const MmsRecordFile file = read(mms_recorded(walk));
  EXPECT_EQ(file.mouse, "mms:./mouse");
  EXPECT_EQ(file.maze_name, "plank");
  EXPECT_EQ(file.maze->size(), (Size{3, 1}));
  ASSERT_EQ(file.events.size(), 5U);
  EXPECT_EQ(file.events[2].line, "moveForward");
  EXPECT_EQ(file.events[2].reply, "ack");
  EXPECT_EQ(file.events[2].pose, (HalfPose{{3, 1}, Compass::east}));
  EXPECT_GT(file.events[2].clock, 0);
  EXPECT_EQ(file.events[3].reply, "");
  ASSERT_TRUE(file.end);
  EXPECT_EQ(file.end->outcome, "complete");
  EXPECT_EQ(file.end->end, "exit code 0");
  EXPECT_TRUE(file.end->statistics.solved);
  EXPECT_EQ(file.end->statistics.total_turns, 1);
  EXPECT_EQ(file.end->lines, 5);
  EXPECT_EQ(disagreement(mms_recorded(walk)), "");
}

TEST(MmsRecordFile, MayBreakOff) {
  const std::string whole = mms_recorded(walk);
  const std::string cut = whole.substr(0, whole.rfind("\n{\"outcome") + 12);
  EXPECT_FALSE(read(cut).end);
  EXPECT_EQ(read(cut).events.size(), 5U);
  EXPECT_EQ(disagreement(cut), "");
}

TEST(MmsRecordFile, MayLeaveEventsOut) {
  const MmsRecordFile file = read(mms_recorded(walk, 2));
  EXPECT_EQ(file.events.size(), 2U);
  EXPECT_EQ(file.left_out, 3);
  EXPECT_EQ(disagreement(mms_recorded(walk, 2)), "");
}

TEST(MmsRecordFile, ThatIsNoneIsRefusedWithItsLine) {
  const std::string good = mms_recorded(walk);
  EXPECT_EQ(problem("").reason, "the record is empty");
  EXPECT_EQ(problem("{").reason, "the line is not JSON");
  EXPECT_EQ(problem("[]").reason, "the line is not an object");
  EXPECT_EQ(problem(changed(good, "mms record", "record")).reason, "the line is not the header of a record of mms");
  EXPECT_EQ(problem(changed(good, "\"format\":1", "\"format\":2")).reason,
            "the line has a format other than 1, which this version does not know");
  EXPECT_EQ(problem(changed(good, "\"maze\"", "\"labyrinth\"")).reason, "'maze' is missing");
  EXPECT_EQ(problem(changed(good, "\"drawing\"", "\"draft\"")).reason, "'maze.drawing' is missing");
  EXPECT_EQ(problem(good + good).reason, "the line stands behind the end of the record");
  EXPECT_EQ(problem(changed(good, "\"statistics\"", "\"sums\"")), (Problem{7, 1, "'statistics' is missing"}));
  EXPECT_EQ(problem(changed(good, "\"total-turns\":1", "\"total-turns\":\"1\"")).reason,
            "'statistics.total-turns' is not a number");
  EXPECT_EQ(problem(changed(good, "\"lines\":5", "\"lines\":5.5")).reason, "'lines' is not a whole number");
  EXPECT_EQ(problem(changed(good, "\"log\":[]", "\"log\":[1]")).reason,
            "the line has a log with a line that is not text");
}

TEST(MmsRecordFile, WithAWrongEventIsRefusedWithItsLine) {
  const std::string good = mms_recorded(walk);
  EXPECT_EQ(problem(changed(good, "\"line\":\"turnRight\"", "\"lime\":\"turnRight\"")),
            (Problem{3, 1, "'line' is missing"}));
  EXPECT_EQ(problem(changed(good, "[3,1]", "[3]")), (Problem{4, 1, "the line has a place that is not [x, y]"}));
  EXPECT_EQ(problem(changed(good, "[3,1]", "[7,1]")).reason, "'place' is outside of 0 to 6");
  EXPECT_EQ(problem(changed(good, "\"heading\":\"east\"", "\"heading\":\"up\"")).reason,
            "the line has a heading that is not one of the eight");
  EXPECT_EQ(problem(changed(good, "\"clock\":0.0", "\"clock\":-1")).reason.substr(0, 19), "'clock' is outside ");
}

TEST(MmsRecordFile, ThatDoesNotFitItsMazeIsToldOf) {
  const std::string good = mms_recorded(walk);
  EXPECT_EQ(disagreement(changed(good, "[3,1]", "[5,1]")),
            "event 3: recorded ack at [5,1] heading east; played ack at [3,1] heading east");
  EXPECT_EQ(disagreement(changed(good, "\"moveForward\"", "\"moveForward 3\"")),
            "event 3: recorded ack at [3,1] heading east; played crash at [5,1] heading east");
  EXPECT_EQ(disagreement(changed(good, "\"turnRight\"", "\"wallFront\"")),
            "event 2: its line neither moves nor draws anything in this maze");
  EXPECT_EQ(disagreement(changed(good, "\"total-turns\":1", "\"total-turns\":2")),
            "the record ends with total-turns 2; played, it is 1");
  EXPECT_THAT(disagreement(changed(good, "\"solved\":true", "\"solved\":false")), HasSubstr("disagree"));
}

}  // namespace
}  // namespace labmouse
