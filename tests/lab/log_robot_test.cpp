// From a log to a robot file, and a robot beside a log.
#include "labmouse/lab/logs/log_robot.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "labmouse/lab/drives/drive_log.hpp"
#include "labmouse/lab/logs/log_comparison.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/robots/robot_file.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "tests/lab/log_simulator.hpp"
#include "tests/lab/xml_scanner.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::LogSimulator;
using test::Says;
using test::SimulatedMouse;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Log log_of(std::string_view text, std::string_view columns) {
  LogResult result = read_log(text, read_log_columns(columns, 0.0).columns);
  EXPECT_THAT(result.problems, IsEmpty());
  return std::move(result.log);
}

constexpr const char* columns = "time=t,left=l,right=r,left_count=cl,right_count=cr,gyro=g";

/// kerise, with the counts of the simulated mouse.
Robot base() {
  Robot robot = find_robot("kerise").robot;
  robot.hardware->sensors.count = SimulatedMouse().count;
  robot.hardware->chassis.half_track = SimulatedMouse().half_track;
  robot.hardware->motors.sag = 0.0;
  return robot;
}

/// The line of a key in a file.
std::string line_of(const std::string& text, const std::string& key) {
  const auto at = text.find("\n" + key + " = ");
  return at == std::string::npos ? "" : text.substr(at + 1, text.find('\n', at + 1) - at - 1);
}

TEST(LogRobot, IsAFileWithErrorsAndTheBaseWhereTheLogSaysNothing) {
  const SimulatedMouse mouse;
  const FittedRobot fitted = robot_by_log(log_of(LogSimulator(mouse, 1).drive(40), columns), "log.csv", base(), {});
  EXPECT_EQ(fitted.error, "");
  EXPECT_EQ(fitted.doubt, "");
  const RobotResult read = read_robot(fitted.text, "fitted");
  ASSERT_TRUE(read.robot && read.robot->hardware);
  const Hardware& hardware = *read.robot->hardware;
  EXPECT_NEAR(hardware.motors.drive.gain, mouse.drive.gain, 30.0);
  EXPECT_NEAR(hardware.motors.turn.time, mouse.turn.time, 0.002);
  EXPECT_NEAR(hardware.noise.gyro, mouse.gyro_noise, 0.001);
  EXPECT_THAT(line_of(fitted.text, "drive_gain"), Says("fitted", "+-"));
  EXPECT_THAT(line_of(fitted.text, "turn_dead_zone"), Says("fitted", "+-"));
  EXPECT_THAT(line_of(fitted.text, "count"), Says("from kerise"));
  EXPECT_THAT(line_of(fitted.text, "infrared_fall"), Says("from kerise"));
  // All else is the base.
  Hardware other = *base().hardware;
  EXPECT_EQ(hardware.sensors, other.sensors);
  EXPECT_EQ(hardware.chassis, other.chassis);
  EXPECT_EQ(read.robot->cell, 90.0);
  EXPECT_THAT(fitted.text, Says("log.csv", "driving: ", "turning: ", "gyro: ", "left out", "infrared: nothing fitted"));
}

TEST(LogRobot, KeepsTheBaseAndSaysWhyWhereAFitIsRefused) {
  SimulatedMouse mouse;
  mouse.second_time = 0.08;
  const FittedRobot fitted = robot_by_log(log_of(LogSimulator(mouse, 1).drive(40), columns), "log.csv", base(), {});
  EXPECT_EQ(fitted.error, "");
  EXPECT_THAT(fitted.doubt, Says("first order"));
  EXPECT_THAT(fitted.text, Says("nothing fitted", "first order"));
  EXPECT_THAT(line_of(fitted.text, "turn_gain"), Says("83", "from kerise"));
  EXPECT_TRUE(read_robot(fitted.text, "fitted").robot);
}

TEST(LogRobot, TellsWhatTheGainGoesWithWhereTheTimeIsNotTold) {
  // At one speed, nothing tells how quickly a mouse comes to it.
  std::string text = "t,l,r,cl,cr\n";
  for (int t = 0; t < 4000; ++t) {
    const double speed = 400.0 + 4.0 * std::sin(t / 40.0);
    text += fmt::format("{},{:.5f},{:.5f},{},{}\n", t, speed / 3000.0, speed / 3000.0, std::floor(4.0 * t),
                        std::floor(4.0 * t));
  }
  const FittedRobot fitted =
      robot_by_log(log_of(text, "time=t,left=l,right=r,left_count=cl,right_count=cr"), "log.csv", base(), {});
  EXPECT_THAT(line_of(fitted.text, "drive_time"), Says("152", "from kerise"));
  EXPECT_NE(fitted.doubt, "");
}

TEST(LogRobot, NeedsABaseThatIsBuiltOfSomething) {
  const Log log = log_of(LogSimulator({}, 1).drive(5), columns);
  EXPECT_THAT(robot_by_log(log, "log.csv", find_robot("half").robot, {}).error, Says("'half'", "kerise"));
}

/// A maze whose fastest route has a dozen turns.
const Maze& maze_of_turns() {
  static const MazeCollection mazes = load_builtin_mazes();
  return std::find_if(mazes.mazes.begin(), mazes.mazes.end(),
                      [](const NamedMaze& maze) { return maze.name == "contest-01"; })
      ->maze;
}

/// A fast drive of kerise without noise.
struct QuietDrive {
  std::string text;
  Robot robot;
};
QuietDrive quiet_drive() {
  FoundRobot found = find_robot("kerise");
  share_route_tables(found.model);
  PhysicalConditions conditions;
  conditions.noise.all = 0.0;
  std::vector<LoggedTick> ticks;
  const Maze& maze = maze_of_turns();
  EXPECT_TRUE(drive_known_way(maze, found.model, conditions, KnownWay::fast, 1, &ticks));
  return {log_text(ticks, Field(maze, found.robot.cell), *found.robot.hardware), found.robot};
}
constexpr const char* duties = "time,left,right,left_count,right_count,gyro*0.00107";

/// The largest difference as a share of the log's peak.
double most_off(const ComparedCurve& curve) {
  double most = 0.0, peak = 0.0;
  for (std::size_t i = 0; i < curve.log.size(); ++i) {
    most = std::max(most, std::abs(curve.robot[i] - curve.log[i]));
    peak = std::max(peak, std::abs(curve.log[i]));
  }
  return most / peak;
}

TEST(LogComparison, OfARobotWithItselfShowsNoDifference) {
  const QuietDrive drive = quiet_drive();
  const LogComparison same = compare_log(log_of(drive.text, duties), drive.robot);
  ASSERT_EQ(same.error, "");
  EXPECT_TRUE(same.by_duties);
  EXPECT_LT(most_off(same.speed), 0.002);
  EXPECT_LT(most_off(same.way), 0.001);
  EXPECT_LT(most_off(same.yaw), 0.02);
  EXPECT_LT(most_off(same.turn), 0.02);
  EXPECT_FALSE(same.speed.parts || same.yaw.parts || same.way.parts || same.turn.parts);
  EXPECT_THAT(table_of(same, "log", "robot"), Says("do not part"));
}

/// It says when a mouse begins to do what the robot does not: here, when its motors get weaker.
TEST(LogComparison, SaysWhereTheTwoPart) {
  std::string text = "t,l,r,cl,cr,g\n";
  const Robot robot = base();
  double speed = 0.0, way = 0.0;
  for (int t = 0; t < 2000; ++t) {
    const double duty = t < 200 ? 0.0 : 0.25;
    text += fmt::format("{},{},{},{},{},0\n", t, duty, duty, std::floor(10.0 * way), std::floor(10.0 * way));
    const double gain = robot.hardware->motors.drive.gain * (t < 1200 ? 1.0 : 0.8);
    const double pushed = duty > 0.0 ? duty - robot.hardware->motors.drive.dead_zone : 0.0;
    speed += 0.001 / robot.hardware->motors.drive.time * (gain * pushed - speed);
    way += 0.001 * speed;
  }
  const LogComparison comparison = compare_log(log_of(text, columns), robot);
  ASSERT_EQ(comparison.error, "");
  ASSERT_TRUE(comparison.speed.parts && comparison.way.parts);
  EXPECT_GT(*comparison.speed.parts, 1190U);
  EXPECT_LT(*comparison.speed.parts, 1280U);
  EXPECT_GT(*comparison.way.parts, *comparison.speed.parts);
  EXPECT_FALSE(comparison.yaw.parts || comparison.turn.parts);
  EXPECT_THAT(table_of(comparison, "log", "robot"),
              Says("speed", fmt::format("{} mm", std::lround(comparison.way.log[*comparison.speed.parts]))));
}

TEST(LogComparison, ShowsByHowMuchARobotIsAnother) {
  LABMOUSE_SKIP_SANITIZED();
  const QuietDrive drive = quiet_drive();
  Robot stronger = drive.robot;
  stronger.hardware->motors.drive.gain *= 1.1;
  const LogComparison comparison = compare_log(log_of(drive.text, duties), stronger);
  EXPECT_NEAR(comparison.way.robot.back() / comparison.way.log.back(), 1.1, 0.01);
  EXPECT_LT(most_off(comparison.turn), 0.02);
  const std::string table = table_of(comparison, "my <log>", "my robot");
  EXPECT_THAT(table, Says("my <log>", "my robot", "speed", "yaw", "way", "turn", "duties"));
  const std::string picture = picture_of(comparison, "my <log>", "my robot");
  EXPECT_EQ(XmlScanner(picture).complaint(), "");
  EXPECT_THAT(picture, HasSubstr("my &lt;log&gt; beside my robot"));
}

TEST(LogComparison, DrivesAfterSpeedsWhereTheLogHasNoDuties) {
  const QuietDrive drive = quiet_drive();
  Robot stronger = drive.robot;
  stronger.hardware->motors.drive.gain *= 1.1;
  const LogComparison after = compare_log(log_of(drive.text, "time,left_count,right_count,gyro*0.00107"), stronger);
  ASSERT_EQ(after.error, "");
  EXPECT_FALSE(after.by_duties);
  // It is controlled, so the gain matters little.
  EXPECT_LT(most_off(after.way), 0.01);
  EXPECT_LT(most_off(after.turn), 0.03);
  std::string told = "t,v,w,cl,cr,g\n";
  for (int t = 0; t < 500; ++t) told += fmt::format("{},{},{},{},{},0\n", t, t < 100 ? 0 : 2 * (t - 100), 0, 0, 0);
  const LogComparison reference =
      compare_log(log_of(told, "time=t,speed=v,turning=w,left_count=cl,right_count=cr,gyro=g"), drive.robot);
  EXPECT_NEAR(reference.speed.robot.back(), 790.0, 40.0);
}

TEST(LogComparison, MakesTheMotorsAsUnequalAsTheLogs) {
  FoundRobot found = find_robot("kerise");
  share_route_tables(found.model);
  PhysicalConditions conditions;
  conditions.noise.groups.fill(0.0);
  conditions.noise.groups[static_cast<std::size_t>(NoiseGroup::motors)] = 1.0;
  for (const std::uint64_t seed : {2U, 5U}) {
    std::vector<LoggedTick> ticks;
    const Maze& maze = maze_of_turns();
    ASSERT_TRUE(drive_known_way(maze, found.model, conditions, KnownWay::fast, seed, &ticks));
    const Specimen specimen(*found.robot.hardware, conditions.noise, maze.size(), seed);
    const double unequal = 2.0 * (specimen.motor[1] - specimen.motor[0]) / (specimen.motor[1] + specimen.motor[0]);
    const LogComparison comparison =
        compare_log(log_of(log_text(ticks, Field(maze, found.robot.cell), *found.robot.hardware), duties), found.robot);
    EXPECT_NEAR(comparison.stronger, unequal, 0.01) << seed;
  }
}

TEST(LogComparison, SaysWhyItCannotCompare) {
  const Robot robot = base();
  EXPECT_THAT(compare_log(log_of("t,x\n0,1\n1,1\n", "time=t"), robot).error, Says("left_count", "gyro"));
  EXPECT_THAT(compare_log(log_of("t,g\n0,0\n1,0\n", "time=t,gyro=g"), robot).error, Says("'left'", "'speed'"));
  std::string moving = "t,l,r\n";
  for (int t = 0; t < 50; ++t) moving += fmt::format("{0},{1},{1}\n", t, 5 * t);
  EXPECT_THAT(compare_log(log_of(moving, "time=t,left_count=l,right_count=r"), robot).error, Says("rest"));
}

}  // namespace
}  // namespace labmouse
