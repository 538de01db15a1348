// Sensors in robot files: pairs, lists, and those that a robot lacks.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/robots/builtin_robots.hpp"
#include "labmouse/lab/robots/hardware_keys.hpp"
#include "labmouse/lab/robots/robot_file.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/lab/robots/robot_json.hpp"
#include "labmouse/lab/robots/robot_keys.hpp"
#include "labmouse/lab/robots/robot_remarks.hpp"
#include "labmouse/lab/robots/robot_text.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;
using ::testing::SizeIs;

constexpr std::string_view three_sensors = R"(
[[infrared]]
ahead = 18
aside = -10
angle = -0.785
gain = 300
fall = 0
[[infrared]]
ahead = 20
aside = 0
angle = 0
[[infrared]]
ahead = 18
aside = 10
angle = 0.785
group = 1
latency = 2
[[ranger]]
ahead = 5
aside = 12
angle = 1.571
reach = 150
period = 33
)";

std::string kerise() {
  const auto robots = builtin_robots();
  return std::string(
      std::find_if(robots.begin(), robots.end(), [](const BuiltinRobot& one) { return one.name == "kerise"; })->text);
}

/// The robot kerise without the keys that begin so; `more` stands at its end.
std::string without(const std::vector<std::string>& keys, std::string_view more = "") {
  std::istringstream lines(kerise());
  std::string text, section;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('[')) section = line.substr(1, line.find(']') - 1);
    const std::string key = section + "." + line;
    if (std::none_of(keys.begin(), keys.end(), [&](const std::string& one) { return key.starts_with(one); }))
      text += line + "\n";
  }
  return text + std::string(more);
}

std::string changed_in(std::string text, std::string_view old, std::string_view now) {
  return text.replace(text.find(old), old.size(), now);
}

const std::vector<std::string> pairs = {"sensors.side_", "sensors.front_"}, ranger = {"sensors.ranger_"};

std::string listed() { return without({"sensors.side_", "sensors.front_", "sensors.ranger_"}, three_sensors); }

std::vector<std::string> reasons(const std::string& text) {
  std::vector<std::string> all;
  for (const Problem& problem : read_robot(text, "it").problems) all.push_back(problem.reason);
  return all;
}

Hardware hardware_in(const std::string& text) {
  const RobotResult result = read_robot(text, "it");
  EXPECT_THAT(reasons(text), IsEmpty());
  return result.robot ? *result.robot->hardware : Hardware();
}

TEST(RobotSensors, InPairsAreMirroredAndTheRightOnesComeFirst) {
  const Sensors sensors = hardware_in(kerise()).sensors;
  ASSERT_THAT(sensors.infrared, SizeIs(4));
  EXPECT_EQ(sensors.infrared[0].beam, (Beam{12.0, -12.0, -1.1624}));
  EXPECT_EQ(sensors.infrared[1].beam, (Beam{20.0, -8.0, -0.0873}));
  EXPECT_EQ(sensors.infrared[2].beam, (Beam{12.0, 12.0, 1.1624}));
  EXPECT_EQ(sensors.infrared[3].beam, (Beam{20.0, 8.0, 0.0873}));
  for (const Infrared& sensor : sensors.infrared) EXPECT_EQ(sensor.fall, 12.9);
  EXPECT_EQ(sensors.rangers, std::vector{(Ranger{{20.0, 0.0, 0.0}, 255.0, 11.0})});
  EXPECT_EQ(sensors.count_bits, 32.0);
}

TEST(RobotSensors, InListsHaveTheUsualNumbersUnlessTheyHaveTheirOwn) {
  const Sensors sensors = hardware_in(listed()).sensors;
  ASSERT_THAT(sensors.infrared, SizeIs(3));
  EXPECT_EQ(sensors.infrared[0], (Infrared{{18.0, -10.0, -0.785}, 300.0, 0.0, 3650.0, 5.0}));
  EXPECT_EQ(sensors.infrared[1], (Infrared{{20.0, 0.0, 0.0}, 700.0, 12.9, 3650.0, 5.0}));
  EXPECT_EQ(sensors.infrared[2], (Infrared{{18.0, 10.0, 0.785}, 700.0, 12.9, 3650.0, 5.0, 1.0, 2.0}));
  EXPECT_EQ(sensors.rangers, std::vector{(Ranger{{5.0, 12.0, 1.571}, 150.0, 33.0})});
}

TEST(RobotSensors, AreTheSameAgainFromJsonAndFromText) {
  for (const std::string& text :
       {kerise(), listed(), without(ranger),
        without({"sensors.side_", "sensors.front_"}, "[[infrared]]\nahead = 1\naside = 2\nangle = 0.5\n"),
        without({"sensors.gyro", "noise.gyro", "variation.gyro"}),
        without({"sensors.acceleration", "noise.acceleration"}), without({"sensors.front_"}),
        without({"sensors.side_", "sensors.front_", "sensors.infrared", "noise.infrared", "variation.infrared"}),
        "infrared = []\n" + without(pairs),
        "ranger = []\n" + without({"sensors.side_", "sensors.front_", "sensors.ranger_"},
                                  "[[infrared]]\nahead = 1\naside = 2\nangle = 0.5\n")}) {
    const RobotResult read = read_robot(text, "it");
    ASSERT_TRUE(read.robot) << reasons(text).front();
    JsonFields fields(ReadJson::object(), "record");
    const Json json = robot_json(*read.robot, RobotParts::with_body);
    const DriveModel again = read_robot_json(fields, ReadJson(json));
    EXPECT_EQ(fields.error(), "");
    EXPECT_EQ(again.robot.hardware, read.robot->hardware);
    EXPECT_EQ(hardware_in(robot_text(ReadJson(robot_values(text)))), *read.robot->hardware);
  }
}

/// Pairs in another order, toed in, crossed, or with a latency have no keys of their own: they stand in lists.
TEST(RobotSensors, AreListedWhereNoKeysDescribeThem) {
  const auto list_of = [](const std::vector<Beam>& beams, int latency = 0) {
    std::string text;
    for (const Beam& beam : beams)
      text += fmt::format("[[infrared]]\nahead = {}\naside = {}\nangle = {}\nlatency = {}\n", beam.ahead, beam.aside,
                          beam.angle, latency);
    return without(pairs, text);
  };
  const auto mirrored = [](double aside, double angle) {
    return std::vector<Beam>{{12.0, -aside, -angle}, {12.0, aside, angle}};
  };
  for (const std::string& text :
       {list_of({{12.0, 12.0, 1.1}, {12.0, -12.0, -1.1}}), list_of(mirrored(8.0, -0.1)), list_of(mirrored(-8.0, 1.1)),
        list_of(mirrored(8.0, 0.7845)), list_of(mirrored(12.0, 1.1), 2)}) {
    const RobotResult read = read_robot(text, "it");
    ASSERT_TRUE(read.robot) << reasons(text).front();
    const Json json = robot_json(*read.robot, RobotParts::with_body);
    EXPECT_TRUE(json["parameters"].contains("infrared")) << text;
    JsonFields fields(ReadJson::object(), "record");
    EXPECT_EQ(read_robot_json(fields, ReadJson(json)).robot.hardware, read.robot->hardware);
    EXPECT_EQ(fields.error(), "");
  }
  const Json pair = robot_json(*read_robot(list_of(mirrored(12.0, 1.1)), "it").robot, RobotParts::with_body);
  EXPECT_TRUE(pair["parameters"].contains("sensors.side_angle"));
}

/// Names in JSON would be lines of a file.
TEST(RobotSensors, InJsonThatIsHostileAreRefused) {
  const Json whole = robot_json(*read_robot(listed(), "it").robot, RobotParts::with_body);
  const std::vector<ReadJson> sensors = {{{"gain = 1\n[body]\nmass", 2}},
                                         {{"gain", "1\nfall = 2"}},
                                         {{"gain", nullptr}},
                                         {{"gain", -1.0}},
                                         1,
                                         ReadJson::array()};
  for (const ReadJson& sensor : sensors)
    for (const std::string_view list : {infrared_list, ranger_list}) {
      ReadJson json(whole);
      json["parameters"][std::string(list)].push_back(sensor);
      JsonFields fields(ReadJson::object(), "record");
      read_robot_json(fields, json);
      EXPECT_NE(fields.error(), "") << sensor;
    }
  ReadJson many(whole);
  many["parameters"][std::string(infrared_list)] = std::vector<ReadJson>(100'000, many["parameters"]["infrared"][0]);
  JsonFields fields(ReadJson::object(), "record");
  read_robot_json(fields, many);
  EXPECT_NE(fields.error(), "");
}

TEST(RobotSensors, MayBeLacking) {
  EXPECT_FALSE(hardware_in(without({"sensors.gyro", "noise.gyro", "variation.gyro"})).sensors.has_gyro());
  EXPECT_FALSE(hardware_in(without({"sensors.acceleration", "noise.acceleration"})).sensors.has_accelerometer());
  EXPECT_THAT(hardware_in(without({"sensors.ranger_", "noise.ranger"})).sensors.rangers, IsEmpty());
  EXPECT_THAT(hardware_in(without({"sensors.front_"})).sensors.infrared, SizeIs(2));
}

TEST(RobotSensors, AreDescribedWholeOrNotAtAll) {
  EXPECT_THAT(reasons(without({"sensors.ranger_reach"})), ElementsAre(Says("sensors.ranger_reach")));
  EXPECT_THAT(reasons(without({"sensors.gyro_most"})), ElementsAre(Says("sensors.gyro_most")));
  EXPECT_THAT(reasons(without({"sensors.front_angle"})), ElementsAre(Says("sensors.front_angle")));
  EXPECT_THAT(reasons(without({"sensors.infrared_gain"})), ElementsAre(Says("sensors.infrared_gain")));
  EXPECT_THAT(reasons(without({"noise.infrared_share"})), ElementsAre(Says("noise.infrared_share")));
  // In a list a sensor needs what it has no usual number for.
  EXPECT_THAT(reasons(without({"sensors.side_", "sensors.front_", "sensors.infrared_most"},
                              "[[infrared]]\nahead = 1\naside = 2\nangle = 0\n")),
              ElementsAre(Says("infrared.most")));
}

TEST(RobotSensors, StandInAListOrUnderTheirKeys) {
  EXPECT_THAT(reasons(kerise() + std::string(three_sensors)),
              IsSupersetOf({Says("sensors.side_angle", "[[infrared]]"), Says("sensors.ranger_reach", "[[ranger]]")}));
}

TEST(RobotSensors, InListsThatAreWrongAreNamed) {
  const auto of = [](std::string_view more) { return reasons(without(pairs, more)); };
  EXPECT_THAT(of("[infrared]\nahead = 1\n"), ElementsAre(Says("infrared", "[[infrared]]")));
  EXPECT_THAT(of("[[infrared]]\nahead = 1\naside = 2\nangel = 0\n"),
              ElementsAre(Says("infrared.angle"), Says("infrared.angel", "infrared.angle")));
  EXPECT_THAT(of("[[infrared]]\nahead = 1\naside = 2\nangle = 90\n"), ElementsAre(Says("infrared.angle", "1.6")));
  EXPECT_THAT(of("[[infrared]]\nahead = 1\naside = 2\nangle = \"left\"\n"), ElementsAre(Says("infrared.angle")));
  EXPECT_THAT(of("[[infrared]]\nahead = 1\naside = 2\nangle = 0\ngroup = 0.5\n"), ElementsAre(Says("infrared.group")));
  EXPECT_THAT(of("[[infrared]]\nahead = 1\naside = 2\nangle = 0\nfall = 0.9\n"), ElementsAre(Says("infrared.fall")));
  std::string many;
  for (int i = 0; i < 17; ++i) many += "[[infrared]]\nahead = 1\naside = 2\nangle = 0\n";
  EXPECT_THAT(of(many), ElementsAre(Says("17", "16")));
}

TEST(RobotSensors, ThatAreLackingAreRemarked) {
  const auto remarks = [](const std::string& text) {
    const RobotResult read = read_robot(text, "it");
    return robot_remarks(*read.robot, read.model);
  };
  EXPECT_THAT(remarks(kerise()), IsEmpty());
  EXPECT_THAT(remarks(without({"sensors.ranger_", "noise.ranger", "sensors.front_"})),
              ElementsAre(Says("no sensor looks ahead"), Says("no ToF sensor looks ahead")));
  EXPECT_THAT(remarks(without({"sensors.acceleration", "noise.acceleration"})), ElementsAre(Says("no accelerometer")));
  EXPECT_THAT(remarks(without({"sensors.gyro", "noise.gyro", "variation.gyro"})), ElementsAre(Says("no gyro")));
  std::string narrow = kerise();
  narrow.replace(narrow.find("count = "), 0, "count_bits = 11\n");
  EXPECT_THAT(remarks(narrow), ElementsAre(Says("11 bits")));
  EXPECT_THAT(remarks(without(pairs, "[[infrared]]\nahead = 12\naside = 9\nangle = 1.1\nlatency = 9\n")),
              Contains(Says("mm late")));
  EXPECT_THAT(remarks(without(pairs, "[[infrared]]\nahead = 12\naside = 9\nangle = 1.1\n")),
              ElementsAre(Says("no sensor looks to the right")));
  EXPECT_THAT(remarks(without({"sensors.side_"})), Contains(Says("no sensor looks aside")));
  EXPECT_THAT(remarks(without(pairs,
                              "[[infrared]]\nahead = 12\naside = 10\nangle = 1.57\n"
                              "[[infrared]]\nahead = 12\naside = -10\nangle = -1.57\n")),
              ElementsAre(Says("no sensor sees its side walls")));
  EXPECT_THAT(remarks(listed()), Not(Contains(Says("no sensor sees its side walls"))));
}

/// Keys that robots of earlier versions lack, read from files and JSON, and left out of JSON where they say nothing.
TEST(RobotBuild, HasMotorsADriverAndACornerOfItsOwn) {
  const std::string motors = "[motors]\n", body = "[body]\n";
  const std::string with =
      changed_in(kerise(), motors, motors + "left = 0.9\nright = 1.1\ndead_time = 0.02\ncoast = 1\n");
  const std::string text = changed_in(with, body, body + "rounding = 17\n");
  const Hardware hardware = hardware_in(text);
  EXPECT_EQ(hardware.motors.strength, (std::array{0.9, 1.1}));
  EXPECT_EQ(hardware.motors.dead_time, 0.02);
  EXPECT_EQ(hardware.motors.coast, 1.0);
  EXPECT_EQ(hardware.chassis.rounding, 17.0);
  const Json json = robot_json(*read_robot(text, "it").robot, RobotParts::with_body);
  JsonFields fields(ReadJson::object(), "record");
  EXPECT_EQ(read_robot_json(fields, ReadJson(json)).robot.hardware, hardware);
  EXPECT_EQ(fields.error(), "");
  const Json plain = robot_json(*read_robot(kerise(), "it").robot, RobotParts::with_body)["parameters"];
  for (const char* key : {"motors.left", "motors.right", "motors.dead_time", "motors.coast", "body.rounding"}) {
    EXPECT_TRUE(json["parameters"].contains(key)) << key;
    EXPECT_FALSE(plain.contains(key)) << key;
  }
  EXPECT_THAT(reasons(changed_in(text, "rounding = 17", "rounding = 17.5")),
              ElementsAre(Says("'body.rounding'", "17")));
  // A number without a unit.
  EXPECT_THAT(reasons(changed_in(text, "left = 0.9", "left = 3")), ElementsAre(Says("'motors.left'", "0.5 to 2")));
  EXPECT_THAT(reasons(changed_in(text, "left = 0.9", "left = \"3\"")), ElementsAre(Not(HasSubstr("in "))));
  EXPECT_THAT(reasons(changed_in(text, "coast = 1", "coast = 0.5")), ElementsAre(Says("'motors.coast'", "0.5")));
}

}  // namespace
}  // namespace labmouse
