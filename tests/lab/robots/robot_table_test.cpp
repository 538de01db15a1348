// Robots as tables and pictures.
#include "labmouse/lab/robots/robot_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/lab/pictures/robot_picture.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "tests/lab/xml_scanner.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::HasSubstr;
using ::testing::Not;

std::string table_of(const std::string& name) {
  const FoundRobot found = find_robot(name);
  return robot_table(found.robot, found.model);
}

std::string picture_of(const std::string& name) {
  const FoundRobot found = find_robot(name);
  return draw_robot(found.robot, found.model);
}

/// How often a word stands in a text.
int count(std::string_view text, std::string_view word) {
  int found = 0;
  for (auto at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

TEST(RobotTable, NamesEveryTurnOnceWithItsSpeeds) {
  EXPECT_THAT(table_of("half"), HasSubstr("half: cells of 90 mm, sees 1 cell far\n"
                                          "turn     mm/s       ms  lead in lead out curve mm clearance\n"
                                          "45      595.0  144.265      0.0     18.7     85.8      31.4\n"
                                          "        560.0  153.282      0.0     18.7     85.8      31.4\n"));
  EXPECT_THAT(table_of("half"), HasSubstr("        380.0  225.889      0.0     18.7     85.8      31.4\n"
                                          "90      560.0  254.105      1.1      1.1    142.3      29.3\n"));
  EXPECT_THAT(table_of("half"), HasSubstr("\nS90     380.0  190.413      0.5      0.5     72.4      45.0\nstraight"));
  EXPECT_THAT(table_of("half"),
              HasSubstr("straight  1500 mm/s, 4200 mm/s² up, 4200 mm/s² down\n"
                        "diagonal  1200 mm/s, 3600 mm/s² up, 3600 mm/s² down\n"
                        "start     at rest, 24 mm behind the middle of the start cell\n"
                        "goal      slow enough to stop in the last open cell straight behind it\n"
                        "search    cell 300 ms, turn 244.502 ms, back 785.587 ms, quarter on the spot "
                        "257.08 ms, half a cell from rest 185.714 ms\n"
                        "tables    "));
}

TEST(RobotTable, LeavesOutWhatGivenTimesDoNotSay) {
  const std::string table = table_of("mm2021");
  EXPECT_THAT(table, HasSubstr("turn     mm/s       ms\n45      406.6  257.000\n90 "));
  EXPECT_THAT(table, HasSubstr("nodes     420 mm/s"));
  EXPECT_THAT(table, Not(HasSubstr("lead in")));
}

TEST(RobotTable, RemarksOnDegrees) {
  const auto remarks = [](auto change) {
    Robot robot = find_robot("classic").robot;
    change(robot);
    const std::string table = robot_table(robot, make_drive_model(robot));
    return table.substr(table.find("tables"));
  };
  EXPECT_THAT(remarks([](Robot&) {}), Not(HasSubstr("remark")));
  EXPECT_THAT(remarks([](Robot& robot) { robot.yaw_acceleration = 17'189.0; }),
              Says("remark", "curve.yaw_acceleration", "17189 rad/s²", "degrees/s²", "write 300\n"));
  EXPECT_THAT(remarks([](Robot& robot) { robot.pivot_acceleration = 5'730.0; }),
              Says("remark", "search.pivot_acceleration", "write 100"));
  EXPECT_THAT(remarks([](Robot& robot) { robot.yaw_speed = 60.0; }), Says("remark", "curve.yaw_speed", "write 1.047"));
  EXPECT_THAT(remarks([](Robot& robot) { robot.yaw_jerk = 1e6; }), Says("remark", "curve.yaw_jerk", "degrees/s³"));
  EXPECT_THAT(remarks([](Robot& robot) { robot.pivot_speed = 90.0; }), Says("remark", "search.pivot_speed", "1.571"));
  for (const char* name : {"half", "kerise", "mm2021"}) EXPECT_THAT(table_of(name), Not(HasSubstr("remark"))) << name;
}

TEST(RobotTable, RemarksOnMetres) {
  Robot robot = find_robot("classic").robot;
  robot.clearance = 0.045, robot.run_up = 0.04;
  EXPECT_THAT(robot_table(robot, make_drive_model(robot)), Says("clearance", "write 45", "run_up", "write 40"));
  robot.clearance = robot.run_up = 0.0;
  EXPECT_THAT(robot_table(robot, make_drive_model(robot)), Not(HasSubstr("remark")));
}

TEST(RobotTable, DoesNotRemarkOnSlowRobots) {
  Robot robot = find_robot("classic").robot;
  robot.lateral_acceleration = 300.0, robot.search_speed = 100.0;
  const DriveModel model = make_drive_model(robot);
  ASSERT_EQ(model.error, "");
  EXPECT_THAT(robot_table(robot, model), Not(HasSubstr("remark")));
}

TEST(RobotTable, SaysARobotInALine) {
  const auto line = [](const std::string& name) {
    const FoundRobot found = find_robot(name);
    return robot_line(found.robot, found.model);
  };
  EXPECT_THAT(line("classic"), Says("180 mm", "3000 mm/s", "850 to 1325 mm/s"));
  EXPECT_THAT(line("mm2021"), Says("90 mm", "1500 mm/s", "420 mm/s"));
}

TEST(RobotTable, WritesItsHashInSixteenDigits) {
  DriveTables tables;
  tables.hash = 0xABC;
  EXPECT_EQ(hash_words(tables), "0000000000000abc");
}

TEST(RobotDrawing, IsXmlWithSixTurns) {
  for (const char* name : {"classic", "half", "mm2021"}) {
    const std::string picture = picture_of(name);
    EXPECT_EQ(XmlScanner(picture).complaint(), "");
    EXPECT_EQ(count(picture, "<circle"), 6) << name;
    for (const char* turn : {"45: ", "90: ", "135: ", "180: ", "V90: ", "S90: "})
      EXPECT_EQ(count(picture, ">" + std::string(turn)), 1) << name << " " << turn;
  }
}

TEST(RobotDrawing, BeginsAndEndsOnItsNodes) {
  const std::string picture = picture_of("half");
  // The second panel, 90: its cells' corner is at 368, 64; a cell has 96 pixels.
  EXPECT_THAT(picture, HasSubstr("<circle r=\"5\" transform=\"translate(512.0 208.0)\"/>"
                                 "<path d=\"M0 -9L7 6L-7 6Z\" transform=\"translate(416.0 112.0) rotate(270)\"/>"));
  EXPECT_THAT(picture, HasSubstr("d=\"M512.0 208.0L"));
  EXPECT_THAT(picture, HasSubstr("L416.0 112.0\""));
}

TEST(RobotDrawing, ShowsTheRoomThatIsKept) {
  // Twice 18 mm of cells of 90 mm, which have 96 pixels.
  EXPECT_EQ(count(picture_of("half"), "stroke-width=\"38.4\""), 6);
  EXPECT_THAT(picture_of("half"), HasSubstr("18 mm on both sides, which stay free"));
  EXPECT_THAT(picture_of("mm2021"), Not(HasSubstr("stay free")));
}

TEST(RobotDrawing, IsNotSteeredByNames) {
  FoundRobot found = find_robot("half");
  found.robot.name = "</title><script>\x1b[2J";
  const std::string picture = draw_robot(found.robot, found.model);
  EXPECT_EQ(XmlScanner(picture).complaint(), "");
  EXPECT_THAT(picture, Not(HasSubstr("<script")));
  EXPECT_THAT(robot_table(found.robot, found.model), Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace labmouse
