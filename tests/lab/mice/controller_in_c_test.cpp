// Controllers in C: by their table of functions, and as the programs that the header makes of them.
#include "labmouse/lab/mice/controller_in_c.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "labmouse/contest/code_contest.hpp"
#include "labmouse/contest/logged_tick.hpp"
#include "labmouse/external/external_controller.hpp"
#include "labmouse/lab/mice/controller_lines.hpp"
#include "labmouse/lab/mice/in_c.hpp"
#include "labmouse/lab/robots/hardware_keys.hpp"
#include "tests/lab/drive/physical_fixture.hpp"

namespace labmouse {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

using Table = struct labmouse_controller;

/// A contest of a minute.
struct Event {
  std::shared_ptr<const DriveModel> model = test::drive_model("kerise");
  DriveRules rules = find_rules("uk-2018").rules;
  PhysicalConditions conditions;

  Event() { rules.time_limit = 60'000'000; }

  ControllerBriefing briefing(std::uint64_t seed = 1) const {
    return controller_briefing(test::ring(), rules, *model, conditions, seed);
  }
  PhysicalRecord hold(ControllerCode& code, std::uint64_t seed = 1) const {
    return drive_by_code(test::ring(), rules, *model, conditions, seed, code);
  }
};

TEST(ControllerInC, KnowsTheNumbersOfARobotByTheirKeys) {
#define LABMOUSE_NAME_OF_NUMBER(section, name) #section "." #name,
  const std::vector<std::string> names = {LABMOUSE_ROBOT_NUMBERS(LABMOUSE_NAME_OF_NUMBER)};
#undef LABMOUSE_NAME_OF_NUMBER
  ASSERT_EQ(names.size(), hardware_keys().size());
  for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(names[i], hardware_keys()[i].key.name);
}

/// What was handed to the functions of a table; tests of one table run one at a time.
struct Calls {
  labmouse_briefing told{};
  std::vector<labmouse_sense> senses;
  std::vector<int> crashes;
  int ends = 0;
} calls;

constexpr Table noting = {[](const labmouse_briefing* told) -> void* {
                            calls = {};
                            calls.told = *told;
                            return &calls;
                          },
                          [](void* memory, const labmouse_sense* sense) -> labmouse_drive {
                            auto& senses = static_cast<Calls*>(memory)->senses;
                            senses.push_back(*sense);
                            if (senses.size() == 3) return {0, 0, LABMOUSE_CARRY};
                            if (senses.size() == 5) return {0, 0, 17};
                            return {100'000, -100'000, LABMOUSE_DRIVE};
                          },
                          [](void* memory, int crashed) { static_cast<Calls*>(memory)->crashes.push_back(crashed); },
                          [](void* memory) { ++static_cast<Calls*>(memory)->ends; }, 1};

TEST(ControllerInC, IsToldWhatItsContestIs) {
  const Event event;
  controller_in_c(noting, event.briefing(5));
  const labmouse_briefing& told = calls.told;
  EXPECT_EQ(told.width, 3);
  EXPECT_EQ(told.height, 3);
  EXPECT_EQ(told.start_heading, LABMOUSE_NORTH);
  ASSERT_EQ(told.goals, 1);
  EXPECT_EQ(told.goal[0].x, 2);
  EXPECT_EQ(told.goal[0].y, 1);
  EXPECT_EQ(told.time_limit, 60'000.0);
  EXPECT_EQ(told.handling, 5000.0);
  EXPECT_EQ(told.seed, 5U);
  EXPECT_EQ(told.cell, event.model->tables.cell);
  EXPECT_EQ(told.touch_penalty, static_cast<double>(event.rules.touch_penalty) / 1000.0);
  EXPECT_EQ(told.untouched_bonus, static_cast<double>(event.rules.untouched_bonus) / 1000.0);
  // In the units of robot files.
  EXPECT_DOUBLE_EQ(told.robot.motors_drive_time, event.model->robot.hardware->motors.drive.time * 1000.0);
  EXPECT_EQ(told.robot.variation_placement, event.model->robot.hardware->variation.placement);
  EXPECT_EQ(calls.ends, 1);
}

TEST(ControllerInC, IsAskedTickByTick) {
  const Event event;
  const auto code = controller_in_c(noting, event.briefing());
  const PhysicalRecord record = event.hold(*code);
  // Duties within their limits, and a word that nobody knows ends the contest.
  constexpr ControllerTick spin = {ControllerTick::full, -ControllerTick::full};
  EXPECT_EQ(record.tape, (std::vector<ControllerTick>{
                             spin, spin, {0, 0, ControllerWord::carry}, spin, {0, 0, ControllerWord::give_up}}));
  EXPECT_THAT(calls.crashes, testing::ElementsAre(0));
  ASSERT_EQ(calls.senses.size(), 5U);
  for (std::size_t i = 1; i < 5; ++i) EXPECT_EQ(calls.senses[i].tick, calls.senses[i - 1].tick + 1);
  EXPECT_NE(calls.senses[2].counts[0], calls.senses[0].counts[0]);
  EXPECT_GT(calls.senses[0].millivolts, 3000);
}

// `labmouse_controller` is that of templates/controller.c, which is linked in.
TEST(ControllerInC, FinishesContestsWithTheTemplate) {
  const Event event;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const auto code = controller_in_c(labmouse_controller, event.briefing(seed));
    EXPECT_EQ(event.hold(*code, seed).drive.outcome, DriveOutcome::finished) << seed;
  }
}

/// Three infrared sensors, two ToF sensors.
Event with_lists() {
  Event event;
  DriveModel model = *event.model;
  Sensors& sensors = model.robot.hardware->sensors;
  sensors.infrared = {sensors.infrared[0], {{20.0, 0.0, 0.0}, 2500.0, 0.0, 3650.0, 5.0, 1.0, 2.0}, sensors.infrared[2]};
  sensors.rangers = {{{5.0, 12.0, 1.571}, 150.0, 33.0}, {{20.0, 0.0, 0.0}, 255.0, 11.0}};
  event.model = std::make_shared<const DriveModel>(model);
  return event;
}

TEST(ControllerInC, KnowsTheSensorsOfAList) {
  const labmouse_robot robot = briefing_in_c(with_lists().briefing()).robot;
  EXPECT_EQ(robot.infrared_sensors, 3);
  EXPECT_EQ(robot.infrared[1].gain, 2500.0);
  EXPECT_EQ(robot.infrared[1].latency, 2.0);
  EXPECT_EQ(robot.range_sensors, 2);
  EXPECT_EQ(robot.ranger[0].period, 33.0);
  EXPECT_EQ(robot.sensors_side_angle, 0.0);
  EXPECT_EQ(robot.sensors_ranger_period, 0.0);
  EXPECT_GT(robot.noise_infrared, 0.0);
}

TEST(ControllerProtocol, TellsEachSensorOfALine) {
  const std::string told = controller_lines(with_lists().briefing());
  EXPECT_THAT(told, HasSubstr("\ninfrared 20 0 0 2500 0 3650 5 1 2\n"));
  EXPECT_THAT(told, HasSubstr("\nranger 5 12 1.571 150 33\nranger 20 0 0 255 11\n"));
  EXPECT_THAT(told, Not(HasSubstr("sensors.side_angle")));
}

#ifdef LABMOUSE_CONTROLLER_TEMPLATE
SpeedControl inner_loop(const Event& event) {
  const ControllerBriefing briefing = event.briefing(7);
  return {*briefing.model.robot.hardware, briefing.model.tables.cell};
}

/// The last sensor of each kind, as a program of C reads it, is the last one that there is.
TEST(ControllerInC, IsAskedWithAllSensorsOfALine) {
  Event event = with_lists();
  event.rules.time_limit = 1'000'000;
  std::vector<LoggedTick> log;
  event.conditions.log = &log;
  Launch launch;
  launch.words = {LABMOUSE_LAST_SENSORS, "1"};
  launch.limits.silence = launch.limits.contest = std::chrono::minutes(5);
  ExternalController program(launch, controller_lines(event.briefing(7)), inner_loop(event));
  const PhysicalRecord record = event.hold(program, 7);
  ASSERT_GT(record.tape.size(), 100U) << program.last_words();
  ASSERT_GE(log.size(), record.tape.size());
  for (std::size_t i = 0; i < record.tape.size(); ++i) {
    EXPECT_EQ(record.tape[i].left, log[i].sense.infrared[2]) << i;
    EXPECT_EQ(record.tape[i].right, log[i].sense.ranges[1].distance) << i;
  }
}

TEST(ControllerInC, IsTheSameAsAProgramThatIsAskedTickByTick) {
  const Event event;
  Launch launch;
  launch.words = {LABMOUSE_CONTROLLER_TEMPLATE, "1"};
  launch.limits.silence = launch.limits.contest = std::chrono::minutes(5);
  ExternalController program(launch, controller_lines(event.briefing(7)), inner_loop(event));
  const auto code = controller_in_c(labmouse_controller, event.briefing(7));
  const PhysicalRecord native = event.hold(*code, 7);
  EXPECT_EQ(event.hold(program, 7), native) << program.last_words();
  EXPECT_EQ(native.drive.outcome, DriveOutcome::finished);
}
#endif

}  // namespace
}  // namespace labmouse
