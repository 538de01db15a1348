// A robot's record, from end to end.
#include "tests/cli/user.hpp"

namespace labmouse::test {
namespace {

using ::testing::HasSubstr;

constexpr const char* robot =
    "{\"labmouse\":\"record\",\"format\":1}\r\n"
    "{\"reading\":[0,0,2],\"action\":[90,1]}\r\n"
    "{\"reading\":[0,1,0],\"action\":[0,1]}\r\n"
    "{\"reading\":[0,0,0],\"action\":\"reset\"}\r\n"
    "{\"reading\":[0,0,2],\"action\":[90,2]}\r\n"
    "{\"outcome\":\"finished\"}\r\n";
constexpr const char* result = "robot in corridor.txt: finished, score 1.100 = 1 speed + 3 search / 30; bound 1.067\n";

class ARobot : public AUser {
 protected:
  ARobot() {
    file("corridor.txt", corridor);
    file("robot.jsonl", robot);
  }
};

TEST_F(ARobot, IsReplayedAndScoredInTheMazeThatIsNamed) {
  const Ended replayed = labmouse({"replay", "robot.jsonl", "--maze", "corridor.txt"});
  EXPECT_EQ(replayed.code, 0) << replayed.err;
  EXPECT_THAT(replayed.out, Says(result, "4 steps", "4 readings", "outcome"));
  const Ended scored = labmouse({"score", "robot.jsonl", "--maze", "corridor.txt"});
  EXPECT_EQ(scored.code, 0);
  EXPECT_EQ(scored.out, result);
}

TEST_F(ARobot, NeedsAMaze) {
  is_refused({"replay", "robot.jsonl"}, "robot.jsonl: error: ", "its maze", "--maze");
  is_refused({"score", "robot.jsonl"}, "robot.jsonl: error: ", "its maze", "--maze");
  is_refused({"show", "--record", "robot.jsonl"}, "robot.jsonl: error: ", "its maze", "--maze");
  is_refused({"score", "robot.jsonl", "--maze", "nowhere.txt"}, "nowhere.txt: error: ", "no such");
}

TEST_F(ARobot, IsToldWhichWallItMisread) {
  std::string text = robot;
  file("robot.jsonl", text.replace(text.find("[0,1,0]"), 7, "[0,2,0]"));
  const Ended scored = labmouse({"score", "robot.jsonl", "--maze", "corridor.txt"});
  EXPECT_EQ(scored.code, 1);
  EXPECT_EQ(scored.out, "");
  EXPECT_THAT(scored.err,
              Says("robot.jsonl: error: ", "step 2: ", "0 2 0", "(1,0) heading east", "0 1 0", "wall east of (2,0)\n"));
}

TEST_F(ARobot, IsDrawnAndWatched) {
  const Ended shown =
      labmouse({"show", "--record", "robot.jsonl", "--maze", "corridor.txt", "--layer", "search,known,path"});
  EXPECT_EQ(shown.code, 0) << shown.err;
  EXPECT_THAT(shown.out, HasSubstr("2 steps to the goal"));
  EXPECT_THAT(shown.out, HasSubstr(result));
  const Ended cut = labmouse({"show", "--record", "robot.jsonl", "--maze", "corridor.txt", "--step", "1"});
  EXPECT_THAT(cut.out, HasSubstr("robot in corridor.txt: step 1 of 4"));
  const Ended watched = labmouse({"replay", "robot.jsonl", "--maze", "corridor.txt", "--watch", "--svg", "robot.svg"});
  EXPECT_EQ(watched.code, 0) << watched.err;
  EXPECT_THAT(watched.out, HasSubstr("step    4  speed run  at (0,0) heading north  sees 0 0 2  turn +90, move +2"));
  EXPECT_THAT(watched.out, Says("checked", "4 steps"));
  EXPECT_THAT(content("robot.svg"), HasSubstr("robot in corridor: score 1.100"));
}

TEST_F(ARobot, BreaksOffWhereItsPowerWentOff) {
  const std::string text = robot;
  file("cut.jsonl", text.substr(0, text.find("\"reset\"")));
  const Ended scored = labmouse({"score", "cut.jsonl", "--maze", "corridor.txt"});
  EXPECT_EQ(scored.code, 0) << scored.err;
  EXPECT_THAT(scored.out, Says("robot in corridor.txt: ", "breaks off", "step 2"));
}

TEST_F(ARobot, OnlyARecordIsPlayedInAnotherMaze) {
  EXPECT_EQ(labmouse({"show", "corridor.txt", "--maze", "corridor.txt"}).code, 2);
}

TEST_F(ARobot, HasNothingToSayOfWhatAMouseRecorded) {
  ASSERT_EQ(labmouse({"run", "flood", "corridor.txt", "--record", "walk.jsonl"}).code, 0);
  EXPECT_EQ(labmouse({"replay", "walk.jsonl"}).out, labmouse({"run", "flood", "corridor.txt"}).out);
}

}  // namespace
}  // namespace labmouse::test
