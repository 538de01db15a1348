// Logs of a mouse, from end to end: a drive writes one, and Python fits a robot to it.
#include <sys/stat.h>

#include "tests/cli/user.hpp"

namespace labmouse::test {
namespace {

using ::testing::HasSubstr;

class ALogger : public AUser {
 protected:
  /// What names an interpreter that does this with its words.
  const char* python(const std::string& script) {
    file("python", "#!/bin/sh\n" + script);
    chmod((folder_ / "python").c_str(), 0700);
    variable_ = "LABMOUSE_PYTHON=" + (folder_ / "python").string();
    return variable_.c_str();
  }

 private:
  std::string variable_;
};

TEST_F(ALogger, LogsOneDrive) {
  const std::vector<std::string> drive = {"drive", "--robot", "kerise", "--mazes", "contest-01"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), drive.begin(), drive.end());
    return more;
  };
  ASSERT_EQ(labmouse(with({"--fast", "--runs", "1", "--log", "run.csv"})).code, 0);
  EXPECT_THAT(content("run.csv"), HasSubstr("time,left,right,left_count,right_count,gyro,"));
  is_refused(with({"contest-02", "--runs", "1", "--log", "run.csv"}), "--log", "--mazes");
  is_refused(with({"--log", "run.csv"}), "--log", "--runs 1");
  is_refused(with({"--noise", "1,2", "--runs", "1", "--log", "r"}), "--log");
  file("plain", "");
  is_refused(with({"--runs", "1", "--log", "plain/run.csv"}), "plain/run.csv");
}

TEST_F(ALogger, IsHandedOverToPythonWordByWord) {
  const char* echo = python("shift 2\nprintf '[%s]' \"$@\"\nexit 3\n");
  const Ended fitted =
      labmouse({"robot", "fit", "a log.csv", "--turns=t", "-x", "--base", "kerise", "--", "--help"}, echo);
  EXPECT_EQ(fitted.out, "[fit][a log.csv][--turns=t][-x][--base][kerise][--][--help]");
  EXPECT_EQ(fitted.code, 3);
  EXPECT_EQ(labmouse({"robot", "compare", "--columns", "a=b, c"}, echo).out, "[compare][--columns][a=b, c]");
}

TEST_F(ALogger, IsToldThatPythonIsMissing) {
  const Ended ended = labmouse({"robot", "fit", "a.csv"}, "LABMOUSE_PYTHON=/nowhere/python");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, Says("error: ", "robot fit", "/nowhere/python"));
}

TEST_F(ALogger, IsToldWhatPythonLacks) {
  const char* bare = python("exec python3 -S -E \"$@\"\n");  // finds no packages but its own
  const Ended ended = labmouse({"robot", "compare", "a.csv"}, bare);
  EXPECT_EQ(ended.code, 2);
  EXPECT_EQ(ended.out, "");
  EXPECT_THAT(ended.err, Says("error: ", "robot compare", "'labmouse'", "pip install"));
}

}  // namespace
}  // namespace labmouse::test
