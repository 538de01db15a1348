// Logs are read strictly: what is wrong is said in one line, with its place.
#include "labmouse/lab/logs/log_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "labmouse/lab/mazes/maze_files.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using test::SaysAt;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

LogColumns columns_of(std::string_view text, double period = 0.0) {
  const LogColumnsResult result = read_log_columns(text, period);
  EXPECT_EQ(result.error, "");
  return result.columns;
}

std::string complaint(std::string_view columns, std::string_view text, double period = 0.0) {
  const LogResult result = read_log(text, columns_of(columns, period));
  EXPECT_THAT(result.problems, SizeIs(testing::Le(1U)));
  return result.problems.empty() ? "" : describe("log", result.problems.front());
}

TEST(LogColumns, HaveRolesWithFactorsAndWraps) {
  const LogColumns columns =
      columns_of("time=ms, left=pwm/255,right=pwm r*-0.5,gyro,left_count=#3%65536,right_count=c*2%8");
  EXPECT_EQ(columns[LogRole::time], (LogColumn{"ms"}));
  EXPECT_EQ(columns[LogRole::left], (LogColumn{"pwm", 1.0 / 255.0}));
  EXPECT_EQ(columns[LogRole::right], (LogColumn{"pwm r", -0.5}));
  EXPECT_EQ(columns[LogRole::gyro], (LogColumn{"gyro"}));
  EXPECT_EQ(columns[LogRole::left_count], (LogColumn{"#3", 1.0, 65536.0}));
  EXPECT_EQ(columns[LogRole::right_count], (LogColumn{"c", 2.0, 8.0}));
  EXPECT_FALSE(columns[LogRole::volts]);
}

TEST(LogColumns, SayWhatIsWrongWithThem) {
  const auto error = [](std::string_view text, double period = 0.0) { return read_log_columns(text, period).error; };
  EXPECT_THAT(error("tme=ms"), Says("'tme'", "'time'"));
  EXPECT_THAT(error("time=ms,speedometer=3"), Says("'speedometer'"));
  EXPECT_THAT(error("time="), Says("'time'", "time=NAME"));
  EXPECT_THAT(error("time=a,time=b"), Says("'time'", "twice"));
  EXPECT_THAT(error("time=a,left=b"), Says("'left'", "'right'"));
  EXPECT_THAT(error("time=a,left_count=b,right_count=c,left_speed=d,right_speed=e"), Says("left_count", "left_speed"));
  EXPECT_THAT(error("gyro=g"), Says("time=NAME", "--period"));
  EXPECT_THAT(error("time=a,gyro=g", 1.0), Says("period"));
  EXPECT_THAT(error("time=a,gyro=g/0"), Says("'gyro=g/0'", "factor"));
  EXPECT_THAT(error("time=a,gyro=g%360"), Says("'gyro'", "counter"));
  EXPECT_THAT(error("time=a,left_count=b%1,right_count=c"), Says("'left_count=b%1'", "65536"));
}

/// One source: the table of docs/logs.md says of each role what the program does.
TEST(LogColumns, MeanWhatTheDocumentationSays) {
  std::ifstream file(std::filesystem::path(LABMOUSE_SOURCE_DIR) / "docs/logs.md");
  std::stringstream text;
  text << file.rdbuf();
  for (const LogRoleWords& role : all_log_roles())
    EXPECT_THAT(text.str(),
                testing::HasSubstr(fmt::format("\n| `{}` | {} | {} |\n", role.name, role.unit, role.meaning)));
}

TEST(LogFile, IsReadByNamesNumbersAndAnySeparator) {
  for (const char* text :
       {"t,x,g\n0,7,1\n1,8,2\n", "\xEF\xBB\xBFt;x;g\r\n\r\n0;7;1\r\n# so far\n1;8;+2", "t\tx\tg\n0\t\t1\n1\t8\t2\n",
        "  t   x g\n 0 7  1 \n1 8 2.0e0\n", "\"t\",x,\"g\"\n0,7,1\n1,8,2\n"}) {
    const LogResult result = read_log(text, columns_of("time=t,gyro=g"));
    ASSERT_THAT(result.problems, IsEmpty()) << text;
    EXPECT_THAT(result.log.times, ElementsAre(0.0, 1.0)) << text;
    EXPECT_THAT(result.log.of(LogRole::gyro), ElementsAre(1.0, 2.0)) << text;
  }
  const LogResult numbers = read_log("5000,3\n5001,4\n", columns_of("time=#1/1000,gyro=#2*0.5"));
  ASSERT_THAT(numbers.problems, IsEmpty());
  EXPECT_NEAR(numbers.log.times[1], 0.001, 1e-12);
  EXPECT_THAT(numbers.log.of(LogRole::gyro), ElementsAre(1.5, 2.0));
  const LogResult periods = read_log("g\n1\n2\n3\n", columns_of("gyro=g", 2.5));
  EXPECT_THAT(periods.log.times, ElementsAre(0.0, 2.5, 5.0));
}

TEST(LogFile, CountersAreFollowedOverTheirEnd) {
  const LogResult result = read_log("t,l,r\n0,65530,3\n1,4,65535\n2,65532,2\n",
                                    columns_of("time=t,left_count=l*-1%65536,right_count=r%65536"));
  ASSERT_THAT(result.problems, IsEmpty());
  EXPECT_THAT(result.log.of(LogRole::left_count), ElementsAre(-65530.0, -65540.0, -65532.0));
  EXPECT_THAT(result.log.of(LogRole::right_count), ElementsAre(3.0, -1.0, 2.0));
}

TEST(LogFile, WhatIsKnownInPlacesMayBeMissingElsewhere) {
  const LogResult result = read_log("t,w,g\n0,,1\n1,40.5,1\n2,-,1\n3,nan,1\n", columns_of("time=t,wall_left=w,gyro=g"));
  ASSERT_THAT(result.problems, IsEmpty());
  const auto walls = result.log.of(LogRole::wall_left);
  EXPECT_EQ(walls[1], 40.5);
  EXPECT_TRUE(std::isnan(walls[0]) && std::isnan(walls[2]) && std::isnan(walls[3]));
  EXPECT_THAT(complaint("time=t,gyro=w", "t,w\n0,1\n1,\n"), SaysAt("log:3:3", "'gyro'", "no value"));
}

TEST(LogFile, SaysWhatIsWrongAndWhatToDo) {
  const char* columns = "time=t,gyro=g";
  EXPECT_THAT(complaint(columns, ""), SaysAt("log", "empty"));
  EXPECT_THAT(complaint(columns, "\n# nothing\n"), SaysAt("log", "empty"));
  EXPECT_THAT(complaint(columns, "t,g\n"), SaysAt("log", "no rows"));
  EXPECT_THAT(complaint(columns, "t,g\n0,1\n"), SaysAt("log", "one row"));
  EXPECT_THAT(complaint(columns, "t,gz\n0,1\n"), SaysAt("log:1:1", "'g'", "'gyro'", "t, gz"));
  EXPECT_THAT(complaint(columns, "t,g,g\n0,1,2\n"), SaysAt("log:1:5", "'g'", "twice", "#3"));
  EXPECT_THAT(complaint(columns, "0,1\n1,2\n"), SaysAt("log:1:1", "#1"));
  EXPECT_THAT(complaint("time=#1,gyro=#3", "0,1\n1,2\n"), SaysAt("log:1:1", "#3", "'gyro'", "2"));
  EXPECT_THAT(complaint("time=#1,gyro=#1.5", "0,1\n1,2\n"), SaysAt("log:1:1", "#1.5"));
  EXPECT_THAT(complaint(columns, "t,g\n0,1\n1,2,3\n"), SaysAt("log:3:1", "3 fields", "2"));
  EXPECT_THAT(complaint(columns, "t,x,g\n0,0,1\n1,0,1\n2,0"), SaysAt("log:4:1", "2 fields", "cut off"));
  EXPECT_THAT(complaint(columns, "t,g\n0,1\n1,fast\n"), SaysAt("log:3:3", "'fast'", "'gyro'"));
  EXPECT_THAT(complaint(columns, "t;g\n0;1\n1;0,5\n"), SaysAt("log:3:3", "'0,5'", "0.5"));
  EXPECT_THAT(complaint(columns, "t,g\n0,1\n1,1e999\n"), SaysAt("log:3:3", "'1e999'"));
  EXPECT_THAT(complaint(columns, "t,g\n0,1\n1,180\n"), SaysAt("log:3:3", "'gyro'", "180", "0.0174533"));
  EXPECT_THAT(complaint("time=t,left=l,right=r", "t,l,r\n0,0,0\n1,90,90\n"), SaysAt("log:3:3", "'left'", "90", "/255"));
  EXPECT_THAT(complaint(columns, "t,g\n5,1\n5,1\n"), SaysAt("log:3:1", "time"));
  EXPECT_THAT(complaint(columns, "t,g\n5,1\n6,1\n4,1\n"), SaysAt("log:4:1", "time"));
  EXPECT_THAT(complaint(columns, "t,g\n5,1\n6,1\n99,1\n"), SaysAt("log:4:1", "93 ms", "cut it"));
  EXPECT_THAT(complaint(columns, "\x01\x02\x7f,\xff\xfe,,,\n\x00\n"), SaysAt("log:1:1", "'t'"));
}

TEST(LogFile, IsNotLongerThanTenMinutes) {
  std::string text = "g\n";
  for (int i = 0; i < 12'002; ++i) text += "1\n";
  EXPECT_THAT(complaint("gyro=g", text, 50.0), SaysAt("log:12003:1", "600 s"));
}

TEST(LogFile, ALongNameDoesNotFillTheMessage) {
  const std::string long_name(100'000, 'x');
  EXPECT_LT(complaint("time=t,gyro=g", long_name + "," + long_name + "\n0,1\n").size(), 200U);
}

}  // namespace
}  // namespace labmouse
