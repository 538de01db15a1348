// Logs of a mouse, from end to end: written by a drive, fitted to a robot, and driven beside it.
#include "tests/cli/user.hpp"

namespace labmouse::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* columns =
    "time,left,right,left_count,right_count,gyro*0.00107,volts=millivolts/1000,ir_right,ir_left,way=true_way,"
    "wall_right=true_wall_right,wall_left=true_wall_left";

class ALogger : public AUser {
 protected:
  void drive(const std::string& name, std::vector<std::string> more = {}) const {
    std::vector<std::string> words = {"drive",      "--robot", "kerise", "--fast", "--mazes",
                                      "contest-01", "--runs",  "1",      "--log",  name};
    words.insert(words.end(), more.begin(), more.end());
    const Ended ended = labmouse(words);
    ASSERT_EQ(ended.code, 0) << ended.err;
  }
};

TEST_F(ALogger, FitsARobotAndDrivesItBesideTheLog) {
  drive("run.csv");
  EXPECT_THAT(content("run.csv"), HasSubstr("time,left,right,left_count,right_count,gyro,"));
  const Ended fitted = labmouse({"robot", "fit", "--log", "run.csv", "--columns", columns, "--base", "kerise"});
  EXPECT_EQ(fitted.code, 0) << fitted.err;
  EXPECT_THAT(fitted.out, Says("run.csv", "driving: ", "left out", "drive_gain = ", "fitted, +- ", "from kerise"));
  file("mine.toml", fitted.out);
  EXPECT_EQ(labmouse({"robot", "show", "mine.toml"}).code, 0);
  const Ended beside =
      labmouse({"robot", "compare", "run.csv", "--columns", columns, "--robot", "mine.toml", "--svg", "beside.svg"});
  EXPECT_EQ(beside.code, 0) << beside.err;
  EXPECT_THAT(beside.out, Says("run.csv", "mine.toml", "duties", "parts at s", "speed", "yaw", "way", "turn", "part"));
  EXPECT_THAT(content("beside.svg"), HasSubstr("run.csv beside mine.toml"));
}

TEST_F(ALogger, LogsOneDrive) {
  is_refused({"drive", "--robot", "kerise", "--mazes", "contest-01", "contest-02", "--runs", "1", "--log", "run.csv"},
             "--log", "--mazes");
  is_refused({"drive", "--robot", "kerise", "--mazes", "contest-01", "--log", "run.csv"}, "--log", "--runs 1");
  is_refused({"drive", "--robot", "kerise", "--mazes", "contest-01", "--noise", "1,2", "--runs", "1", "--log", "r"},
             "--log");
  file("plain", "");
  is_refused({"drive", "--robot", "kerise", "--mazes", "contest-01", "--runs", "1", "--log", "plain/run.csv"},
             "plain/run.csv");
}

TEST_F(ALogger, IsToldWhereALogIsWrong) {
  const auto fit = [](const std::string& log, const std::string& what) {
    return std::vector<std::string>{"robot", "fit", "--log", log, "--columns", what};
  };
  file("log.csv", "ms,l,r,g\n0,0,0,0\n1,0.5,0.5,0\n2,90,90,0\n");
  const std::string plain = "time=ms,left=l,right=r,gyro=g";
  is_refused(fit("nowhere.csv", plain), "nowhere.csv: error: ", "no such");
  is_refused(fit("log.csv", plain), "log.csv:4:3: error: ", "'left' is 90", "/255");
  is_refused(fit("log.csv", "time=ms,gyro=gz"), "log.csv:1", "'gz'", "ms, l, r, g");
  is_refused(fit("log.csv", "time=ms,gyr0=g"), "--columns", "'gyr0'", "'gyro'");
  is_refused(fit("log.csv", "gyro=g"), "--columns", "time=NAME", "--period");
  is_refused({"robot", "fit", "--log", "log.csv"}, "--columns");
  is_refused({"robot", "fit", "--log", "log.csv", "--turns", "log.csv"}, "--turns", "--log");
  is_refused({"robot", "fit"}, "--turns", "--log");
  file("gap.csv", "ms,g\n0,0\n1,0\n99,0\n");
  is_refused(fit("gap.csv", "time=ms,gyro=g"), "gap.csv:4:1: error: ", "98 ms");
  file("empty.csv", "");
  is_refused(fit("empty.csv", "time=ms,gyro=g"), "empty.csv: error: ", "empty");
  file("binary.csv", std::string("\x7f"
                                 "ELF\x00\x01\xff\xfe,,\n\x00",
                                 14));
  is_refused(fit("binary.csv", "time=ms,gyro=g"), "binary.csv");
  file("good.csv", "ms,g\n0,0\n1,0\n");
  is_refused({"robot", "fit", "--log", "good.csv", "--columns", "time=ms,gyro=g", "--base", "half"}, "good.csv",
             "'half'", "kerise");
  is_refused({"robot", "compare", "gap.csv", "--columns", "time=ms,gyro=g"}, "gap.csv:4:1: error: ");
  is_refused({"robot", "compare", "gap.csv", "--columns", "time=ms,gyro=g", "--robot", "half"}, "half", "kerise");
}

/// More than any log has is not read for minutes.
TEST_F(ALogger, IsToldThatALogIsTooLarge) {
  {
    std::ofstream log(folder_ / "huge.csv", std::ios::binary);
    log << "g\n";
  }
  std::filesystem::resize_file(folder_ / "huge.csv", (std::uintmax_t{1} << 27U) + 1);
  is_refused({"robot", "fit", "--log", "huge.csv", "--columns", "gyro=g", "--period", "1"}, "huge.csv: error: ");
}

TEST_F(ALogger, IsToldWhatALogDoesNotDetermine) {
  std::string still = "ms,l,r,cl,cr\n";
  for (int t = 0; t < 300; ++t) still += std::to_string(t) + ",0,0,0,0\n";
  file("still.csv", still);
  const Ended fitted = labmouse({"robot", "fit", "--log", "still.csv", "--base", "kerise", "--columns",
                                 "time=ms,left=l,right=r,left_count=cl,right_count=cr"});
  EXPECT_EQ(fitted.code, 1);
  EXPECT_THAT(fitted.out, Says("driving: nothing fitted", "drive_gain = 4216"));
  EXPECT_THAT(fitted.out, Not(HasSubstr("+- 0")));
  EXPECT_THAT(fitted.err, Says("still.csv", "driving"));
}

}  // namespace
}  // namespace labmouse::test
