// labmouse robot, from end to end.
#include "tests/cli/user.hpp"

namespace labmouse::test {
namespace {

using ::testing::StartsWith;

using ABuilder = AUser;

TEST_F(ABuilder, ListsTheRobots) {
  const Ended ended = labmouse({"robot", "list"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, StartsWith("beginner  cells of 180 mm"));
  EXPECT_EQ(std::count(ended.out.begin(), ended.out.end(), '\n'), 5);
}

TEST_F(ABuilder, SeesTheClassicRobotWhereNoneIsNamed) {
  const Ended ended = labmouse({"robot", "show"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.out, labmouse({"robot", "show", "classic"}).out);
  EXPECT_THAT(ended.out, StartsWith("classic: cells of 180 mm"));
}

TEST_F(ABuilder, SavesAPictureInPlaceOfTheTable) {
  const Ended ended = labmouse({"robot", "show", "half", "--svg", "half.svg"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.out, "");
  EXPECT_THAT(content("half.svg"), StartsWith("<svg "));
}

TEST_F(ABuilder, ReadsARobotAsJson) {
  const auto robot = nlohmann::json::parse(labmouse({"robot", "show", "kerise", "--format", "json"}).out);
  EXPECT_EQ(robot.at("robot").at("parameters").at("motors.drive_gain"), 4216);
  EXPECT_EQ(robot.at("turns").at(0).at("turn"), "45");
  EXPECT_GT(robot.at("turns").at(0).at("speeds").at(0).at("ms"), 0.0);
  // Of given times the curves are not known.
  const auto given = nlohmann::json::parse(labmouse({"robot", "show", "mm2021", "--format", "json"}).out);
  EXPECT_TRUE(given.at("turns").at(0).at("length").is_null());
  is_refused({"robot", "show", "--format", "json", "--c", "plain"}, "--c", "--format json");
}

TEST_F(ABuilder, IsToldAllThatIsWrongWithAFile) {
  file("my.toml", "cell = 9\nspeed = 3\n[straight]\nspeed = 3000\nacceleration = 10000\n[turns]\n");
  const Ended ended = labmouse({"robot", "show", "my.toml"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_EQ(ended.out, "");
  EXPECT_THAT(ended.err,
              Says("my.toml:1:8: error: ", "'cell'", "9", "20 to 1000 mm", "\nmy.toml:2:1: error: ", "'speed'"));
  EXPECT_THAT(ended.err, Says("missing", "'turns.45'", "1 to 10000 ms"));
}

TEST_F(ABuilder, FindsLogsOnlyInThePhysicalWorld) {
  is_refused({"run", "flood", "parallel-8", "--log", "a.csv"}, "--log", "physical");
  is_refused({"run", "flood", "parallel-8", "--world", "failures", "--log", "a.csv"}, "--log", "physical");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.csv"));
}

TEST_F(ABuilder, IsRefused) {
  is_refused({"robot", "show", "hovercraft"}, "'hovercraft'", "beginner, classic, half, kerise, mm2021");
  is_refused({"robot", "show", "./none"}, "./none: error: ", "no such");
  is_refused({"robot", "show", "."}, "robot '.'");
  is_refused({"robot", "show", "--svg", "none/"}, "none");
  is_refused({"robot", "shoe"}, "'shoe'", "`labmouse robot --help`");
  is_refused({"robot"}, "`labmouse robot --help`");
  is_refused({"robot", "show", "--svgg"}, "'--svgg'", "'--svg'", "`labmouse robot show --help`");
}

TEST_F(ABuilder, IsToldOfLikelyMistakes) {
  const std::string builtin = content_of(std::string(LABMOUSE_SOURCE_DIR) + "/robots/classic.toml");
  std::string degrees = builtin;
  degrees.replace(degrees.find("yaw_acceleration = 300"), 22, "yaw_acceleration = 17189");
  file("degrees.toml", degrees);
  for (const Ended& ended : {labmouse({"route", "parallel-8", "--robot", "degrees.toml"}),
                             labmouse({"race", "--world", "seconds", "--robot", "degrees.toml", "--mice", "flood",
                                       "--mazes", "parallel-8"})}) {
    EXPECT_EQ(ended.code, 0);
    EXPECT_THAT(ended.err, Says("degrees.toml", "curve.yaw_acceleration", "write 300"));
  }
  file("word.toml", "diagonals = no\n" + builtin);
  is_refused({"robot", "show", "word.toml"}, "word.toml:1:", "write false");
}

}  // namespace
}  // namespace labmouse::test
