// Contests of robots with other sensors than pairs and one straight ahead, and with a slower loop.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "labmouse/lab/drives/drive_log.hpp"
#include "labmouse/lab/drives/known_drives.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/records/drive_record_file.hpp"
#include "tests/lab/drive/physical_fixture.hpp"

namespace labmouse {
namespace {

using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr double quarter = 1.5708;

Infrared infrared(double ahead, double aside, double angle) {
  return {{ahead, aside, angle}, 700.0, 12.9, 3650.0, 5.0};
}

struct Build {
  std::string name;
  std::function<void(Hardware&)> make;
};
void PrintTo(const Build& build, std::ostream* out) { *out << build.name; }

class ARobot : public ::testing::TestWithParam<Build> {
 protected:
  ARobot() { GetParam().make(*model_.robot.hardware); }

  PhysicalRecord driven(const PhysicalConditions& conditions, std::uint64_t seed = 1) const {
    Briefing briefing = brief(test::ring(), rules_, model_, seed);
    briefing.sight = 1;
    const BuiltinMouse& entry = *find_mouse("flood-return");
    const auto strategy = entry.drive(briefing, Settings(entry.parameters));
    return drive_physically(test::ring(), rules_, model_, conditions, seed, *strategy);
  }

  DriveModel model_ = *test::drive_model("kerise");
  DriveRules rules_ = find_rules("all-japan").rules;
};

TEST_P(ARobot, SearchesAndRunsWithoutAWrongWall) {
  PhysicalConditions conditions = test::at_errors(0.0);
  for (const double noise : {0.0, 1.0}) {
    conditions.errors.noise = noise;
    const PhysicalRecord record = driven(conditions);
    EXPECT_EQ(record.drive.outcome, DriveOutcome::finished) << noise;
    EXPECT_EQ(record.wrong_walls + record.contradictions + record.carried, 0) << noise;
    EXPECT_THAT(record.ends, Each(RunEnd::done)) << noise;
  }
}

TEST_P(ARobot, IsReadFromItsRecordAsItWasWritten) {
  DriveRecordFile file = test::physical_file("flood-return", test::at_errors(0.0));
  file.model = std::make_shared<const DriveModel>(model_);
  PhysicalConditions conditions = test::at_errors(1.0);
  conditions.trace_every = 100;
  PhysicalRecord record = driven(conditions);
  ASSERT_FALSE(record.trace.empty());
  EXPECT_THAT(record.trace.front().infrared, SizeIs(model_.robot.hardware->sensors.infrared.size()));
  file.record = std::move(record.drive);
  file.physical = PhysicalPart{conditions, std::move(record), physical_edition, "", ""};
  file.recorded_score = score(file.record, file.rules).runs[*score(file.record, file.rules).best];
  const std::string written = write_drive_record(file);
  const auto read = read_drive_record(written);
  ASSERT_TRUE(read.file) << read.problems.front().reason;
  EXPECT_EQ(write_drive_record(*read.file), written);
}

INSTANTIATE_TEST_SUITE_P(
    All, ARobot,
    ::testing::Values(Build{"no_gyro",
                            [](Hardware& hardware) { hardware.sensors.gyro_step = hardware.sensors.gyro_most = 0.0; }},
                      Build{"no_accelerometer", [](Hardware& hardware) { hardware.sensors.acceleration_step = 0.0; }},
                      Build{"loop_of_500_Hz", [](Hardware& hardware) { hardware.motors.period = 2.0; }},
                      Build{"motors_of_different_strength",
                            [](Hardware& hardware) {
                              hardware.motors.strength = {0.85, 1.1};
                            }},
                      Build{"driver_with_dead_time", [](Hardware& hardware) { hardware.motors.dead_time = 0.03; }},
                      Build{"motors_that_coast", [](Hardware& hardware) { hardware.motors.coast = 1.0; }},
                      Build{"round_chassis",
                            [](Hardware& hardware) {
                              hardware.chassis.front = hardware.chassis.back = hardware.chassis.half_width =
                                  hardware.chassis.rounding = 17.0;
                            }},
                      Build{"four_wheels",
                            [](Hardware& hardware) {
                              // They slide sideways where it turns: they roll farther, and friction takes more.
                              hardware.chassis.half_track *= 1.5;
                              hardware.motors.turn.dead_zone += 0.05;
                            }},
                      Build{"narrow_counters", [](Hardware& hardware) { hardware.sensors.count_bits = 16.0; }},
                      Build{"ToF_sensors_alone",
                            [](Hardware& hardware) {
                              Sensors& sensors = hardware.sensors;
                              sensors.infrared.clear();
                              for (const double side : {-1.0, 1.0})
                                sensors.rangers.push_back({{12.0, side * 12.0, side * 1.2}, 255.0, 11.0});
                            }},
                      Build{"six_infrared_sensors",
                            [](Hardware& hardware) {
                              Sensors& sensors = hardware.sensors;
                              sensors.infrared.clear();
                              for (const double side : {-1.0, 1.0}) {
                                sensors.infrared.push_back(infrared(12.0, side * 12.0, side * quarter));
                                sensors.infrared.push_back(infrared(16.0, side * 10.0, side * 0.7854));
                                sensors.infrared.push_back(infrared(20.0, side * 6.0, 0.0));
                              }
                              for (std::size_t i = 0; i < sensors.infrared.size(); ++i) {
                                sensors.infrared[i].group = static_cast<double>(i % 2);
                                sensors.infrared[i].latency = 1.0;
                              }
                            }},
                      Build{"one_infrared_sensor_ahead",
                            [](Hardware& hardware) {
                              Sensors& sensors = hardware.sensors;
                              sensors.rangers.clear();
                              sensors.infrared = {sensors.infrared[0], infrared(20.0, 0.0, 0.0), sensors.infrared[2]};
                              sensors.infrared[1].gain = 2500.0;
                              sensors.infrared[1].fall = 0.0;
                            }}),
    [](const ::testing::TestParamInfo<Build>& tested) { return tested.param.name; });

/// Without sensors that look ahead, a mouse drives known ways by those that look aside.
TEST(ARobotWithSideSensorsAlone, DrivesWhereItKnowsTheWalls) {
  const auto crashed = [](std::vector<Infrared> infrared) {
    DriveModel model = *test::drive_model("kerise");
    Sensors& sensors = model.robot.hardware->sensors;
    sensors.rangers.clear();
    sensors.infrared = std::move(infrared);
    sensors.acceleration_step = 0.0;
    DriveOrder order;
    order.model = std::make_shared<const DriveModel>(model);
    order.way = KnownWay::search;
    order.runs = 10;
    const std::vector<NamedMaze> mazes = {load_builtin_mazes().mazes.front()};
    const std::vector<DriveCase> cases = {{"contest", test::at_variation(1.0)}};
    return drive_known_ways(order, mazes, cases).front().crashed;
  };
  const std::vector<Infrared> all = test::drive_model("kerise")->robot.hardware->sensors.infrared;
  EXPECT_LE(crashed({all[0], all[2]}), 1);
  EXPECT_GE(crashed({}), 6);
}

TEST(DriveLog, HasAColumnForEachSensor) {
  Hardware hardware = *test::drive_model("kerise")->robot.hardware;
  const Field field(test::ring(), 90.0);
  const auto heading = [&] { return log_text({}, field, hardware); };
  EXPECT_THAT(heading(),
              HasSubstr(",acceleration_left,ir_right,ir_right_ahead,ir_left,ir_left_ahead,range,millivolts,"));
  hardware.sensors.infrared.push_back(infrared(20.0, 0.0, 0.0));
  hardware.sensors.infrared.push_back(infrared(20.0, 5.0, 1.0));
  hardware.sensors.rangers = {{{5.0, 5.0, quarter}, 255.0, 11.0}, {{5.0, 6.0, quarter}, 255.0, 11.0}};
  EXPECT_THAT(heading(), HasSubstr(",ir_left_ahead,ir_ahead,ir_5,range_left,range_1,millivolts,"));
}

}  // namespace
}  // namespace labmouse
