// What a log says of a mouse, and how sure it is of that: on logs of the physical world, and of a mouse that is none of
// its own.
#include "labmouse/lab/logs/log_fit.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "labmouse/body/body.hpp"
#include "labmouse/functions/normal.hpp"
#include "labmouse/lab/drives/drive_log.hpp"
#include "labmouse/lab/logs/log_motion.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "tests/lab/log_simulator.hpp"
#include "tests/lab/physical_fixture.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::LogSimulator;
using test::Says;
using test::SimulatedMouse;
using ::testing::IsEmpty;

constexpr const char* world_columns =
    "time,left,right,left_count,right_count,gyro*0.00107,volts=millivolts/1000,ir_right,ir_left,ir_right_ahead,"
    "ir_left_ahead,way=true_way,wall_right=true_wall_right,wall_left=true_wall_left,wall_ahead=true_wall_ahead";
constexpr const char* simulated_columns =
    "time=t,left=l,right=r,left_count=cl,right_count=cr,gyro=g,ir_left=ir,wall_left=wall";

Log log_of(std::string_view text, std::string_view columns) {
  LogResult result = read_log(text, read_log_columns(columns, 0.0).columns);
  EXPECT_THAT(result.problems, IsEmpty());
  return std::move(result.log);
}

/// A number of a mouse as fits say it, beside what it is.
class Score {
 public:
  void add(const std::string& name, const Estimate& said, double truth) {
    if (!said.said()) return;
    Count& count = counts_[name];
    ++count.all;
    // The 95 % of Student's distribution for 20 blocks.
    if (std::abs(said.value - truth) < 2.09 * said.error) ++count.held;
    count.error += said.error / truth;
  }
  int times(const std::string& name) { return counts_[name].all; }
  double held(const std::string& name) { return static_cast<double>(counts_[name].held) / counts_[name].all; }
  /// The mean of the relative errors.
  double error(const std::string& name) { return counts_[name].error / counts_[name].all; }
  double held_of_all() const {
    int all = 0, held = 0;
    for (const auto& [name, count] : counts_) all += count.all, held += count.held;
    return static_cast<double>(held) / all;
  }

 private:
  struct Count {
    int all = 0, held = 0;
    double error = 0.0;
  };
  std::map<std::string, Count> counts_;
};

/// Logs of fast drives of kerise in contest mazes, each with luck of its own.
TEST(LogFit, RecoversTheNumbersOfOurWorldWithinItsErrors) {
  LABMOUSE_SKIP_SANITIZED();
  FoundRobot found = find_robot("kerise");
  ASSERT_TRUE(found.robot.hardware);
  const Hardware& hardware = *found.robot.hardware;
  share_route_tables(found.model);
  const MazeCollection mazes = load_builtin_mazes();
  Score score;
  int logs = 0;
  for (std::uint64_t seed = 1; logs < test::fewer(40); ++seed) {
    const Maze& maze = mazes.mazes[seed % mazes.mazes.size()].maze;
    std::vector<LoggedTick> ticks;
    const PhysicalConditions conditions = test::at_noise(1.0);
    const auto drive = drive_known_way(maze, found.model, conditions, KnownWay::fast, seed, &ticks);
    if (!drive || drive->crashed || ticks.size() < 5000) continue;
    ++logs;
    const Log log = log_of(log_text(ticks, Field(maze, found.robot.cell), hardware), world_columns);
    const LogFit fit = fit_log(log, hardware, found.robot.cell, {});
    ASSERT_EQ(fit.error, "");
    const Specimen specimen(hardware, conditions.noise, maze.size(), seed);
    const double motor = (specimen.motor[0] + specimen.motor[1]) / 2.0;
    score.add("drive gain", fit.drive.gain, hardware.motors.drive.gain * motor);
    score.add("drive time", fit.drive.time, hardware.motors.drive.time);
    score.add("drive dead zone", fit.drive.dead_zone, hardware.motors.drive.dead_zone / motor);
    score.add("turn gain", fit.turn.gain, hardware.motors.turn.gain * motor);
    score.add("turn time", fit.turn.time, hardware.motors.turn.time);
    score.add("turn dead zone", fit.turn.dead_zone, hardware.motors.turn.dead_zone / motor);
    score.add("unequal", fit.turn.mixed, (specimen.motor[1] - specimen.motor[0]) / motor);
    score.add("turning", fit.drive.taking, hardware.motors.turning / motor);
    score.add("count", fit.count.count, hardware.sensors.count * 2.0 / (specimen.encoder[0] + specimen.encoder[1]));
    score.add("gyro", fit.gyro.noise, hardware.noise.gyro);
    score.add("infrared gain", fit.infrared.gain, hardware.sensors.infrared.gain);
    score.add("infrared fall", fit.infrared.fall, hardware.sensors.infrared.fall);
  }
  // A few logs are too few to judge errors by.
  if (!test::thorough) return;
  for (const char* name : {"drive gain", "drive time", "drive dead zone", "turn gain", "turn time", "turn dead zone",
                           "unequal", "turning", "count", "gyro", "infrared gain", "infrared fall"}) {
    EXPECT_GE(score.times(name), 35) << name;
    EXPECT_GE(score.held(name), 0.85) << name;
  }
  EXPECT_GE(score.held_of_all(), 0.93);
  // Errors that hold because they are large would be no news.
  EXPECT_LT(score.error("drive gain"), 0.005);
  EXPECT_LT(score.error("drive time"), 0.005);
  EXPECT_LT(score.error("turn gain"), 0.09);
  EXPECT_LT(score.error("turn time"), 0.09);
  EXPECT_LT(score.error("count"), 0.001);
  EXPECT_LT(score.error("gyro"), 0.1);
  EXPECT_LT(score.error("infrared gain"), 0.05);
}

/// A mouse that a hand puts into closed cells, a little farther from their walls each time.
TEST(LogFit, RecoversInfraredFromKnownPlaces) {
  LABMOUSE_SKIP_SANITIZED();
  const FoundRobot found = find_robot("kerise");
  const Hardware& hardware = *found.robot.hardware;
  const double cell = found.robot.cell;
  const Maze maze(MazeDraft({4, 4}, MazeDraft::Inside::closed));
  Score score;
  for (std::uint64_t seed = 1; seed <= test::fewer(40U); ++seed) {
    NoiseLevel level;
    level.groups[static_cast<std::size_t>(NoiseGroup::placement)] = 0.0;
    Body body(maze, cell, hardware, level, seed);
    std::vector<LoggedTick> ticks;
    for (int place = 0; place < 12; ++place) {
      const double aside = -15.0 + 30.0 * place / 11.0;
      body.put({(place % 4 + 0.5) * cell + aside, (place / 4 + 0.5) * cell}, pi / 2.0);
      for (int tick = 0; tick < 40; ++tick) {
        body.step({});
        ticks.push_back({body.sense(), {}, body.motion()});
      }
    }
    const Log log = log_of(log_text(ticks, body.field(), hardware), world_columns);
    const InfraredFit fit = fit_infrared(log, hardware, cell);
    ASSERT_EQ(fit.refusal, "");
    EXPECT_EQ(fit.places, 24U);
    score.add("gain", fit.gain, hardware.sensors.infrared.gain);
    score.add("fall", fit.fall, hardware.sensors.infrared.fall);
    EXPECT_NEAR(fit.of_beam[0] / hardware.sensors.infrared.gain / body.specimen().infrared[0], 1.0, 0.08);
  }
  EXPECT_GE(score.held("gain"), 0.88);
  EXPECT_GE(score.held("fall"), 0.88);
  EXPECT_LT(score.error("gain"), 0.05);
  EXPECT_LT(score.error("fall"), 0.04);
}

/// The hardware that a fit to the simulated mouse begins with.
Hardware simulated_hardware(const SimulatedMouse& mouse) {
  Hardware hardware = *find_robot("kerise").robot.hardware;
  hardware.sensors.count = mouse.count;
  hardware.chassis.half_track = mouse.half_track;
  hardware.motors.sag = 0.0;
  hardware.noise.encoder_scale = 0.002;  // its counts are known
  hardware.sensors.infrared.beams[static_cast<std::size_t>(BeamPlace::left)].angle = pi / 2.0;
  return hardware;
}

LogFit fit_of(const SimulatedMouse& mouse, const std::string& text) {
  return fit_log(log_of(text, simulated_columns), simulated_hardware(mouse), 90.0, {});
}

TEST(LogFit, RecoversAMouseOfAnotherMaking) {
  LABMOUSE_SKIP_SANITIZED();
  Score score;
  for (std::uint64_t seed = 1; seed <= test::fewer(20U); ++seed) {
    const SimulatedMouse mouse;
    const LogFit fit = fit_of(mouse, LogSimulator(mouse, seed).drive(40));
    EXPECT_EQ(fit.drive.refusal + fit.turn.refusal + fit.gyro.refusal, "");
    score.add("drive gain", fit.drive.gain, mouse.drive.gain);
    score.add("drive dead zone", fit.drive.dead_zone, mouse.drive.dead_zone);
    score.add("turn gain", fit.turn.gain, mouse.turn.gain);
    score.add("gyro", fit.gyro.noise, mouse.gyro_noise);
    EXPECT_NEAR(fit.drive.time.value, mouse.drive.time, 0.002);
    EXPECT_NEAR(fit.turn.time.value, mouse.turn.time, 0.002);
    EXPECT_NEAR(fit.turn.dead_zone.value, mouse.turn.dead_zone, 0.001);
    EXPECT_LT(fit.drive.missed, 2.0);
  }
  EXPECT_GE(score.held_of_all(), 0.9);
}

/// A current that follows its duty slowly makes a motor one of the second order. Its gain is still what a steady duty
/// leads to, and no time constant is the right one.
TEST(LogFit, IsLessSureOfAMotorOfTheSecondOrderOrRefusesIt) {
  int refused = 0, fits = 0;
  for (const double slow : {0.01, 0.02, 0.04, 0.08})
    for (std::uint64_t seed = 1; seed <= test::fewer(5U); ++seed) {
      SimulatedMouse mouse;
      const LogFit first = fit_of(mouse, LogSimulator(mouse, seed).drive(40));
      mouse.second_time = slow;
      const LogFit fit = fit_of(mouse, LogSimulator(mouse, seed).drive(40));
      for (const auto& [motor, plain, truth] :
           {std::tuple(&fit.drive, &first.drive, mouse.drive), std::tuple(&fit.turn, &first.turn, mouse.turn)}) {
        ++fits;
        EXPECT_GT(motor->missed, 3.0 * motor->noise) << slow;
        if (!motor->refusal.empty()) {
          ++refused;
          EXPECT_THAT(motor->refusal, testing::AnyOf(Says("first order"), Says("left out", "noise"))) << slow;
          EXPECT_FALSE(motor->gain.said() || motor->time.said() || motor->dead_zone.said());
          continue;
        }
        EXPECT_GT(motor->lag, 0.3 * slow);
        EXPECT_LT(motor->lag, 1.5 * slow);
        EXPECT_GT(motor->gain.error, 5.0 * plain->gain.error);
        EXPECT_LT(std::abs(motor->gain.value - truth.gain), 2.5 * motor->gain.error);
        if (!motor->time_known) continue;
        EXPECT_GT(motor->time.error, 0.3 * slow);
        EXPECT_LT(std::abs(motor->time.value - truth.time), 2.5 * motor->time.error);
      }
    }
  EXPECT_GT(refused, 0);
  EXPECT_LT(refused, fits);
}

TEST(LogFit, RefusesInfraredThatFollowsAnotherLaw) {
  for (std::uint64_t seed = 1; seed <= test::fewer(10U); ++seed) {
    SimulatedMouse mouse;
    const LogFit exponential = fit_of(mouse, LogSimulator(mouse, seed).stand(12, 20.0, 20.0));
    EXPECT_LT(std::abs(exponential.infrared.fall.value - mouse.ir_fall), 3.0 * exponential.infrared.fall.error);
    EXPECT_LT(std::abs(exponential.infrared.gain.value - mouse.ir_gain), 3.0 * exponential.infrared.gain.error);
    mouse.inverse_square = true;
    // Over 20 mm an exponential misses readings by far, over 10 mm another law just fits better; over 8 mm it may do,
    // but is less sure.
    for (const double range : {20.0, 10.0}) {
      const LogFit wide = fit_of(mouse, LogSimulator(mouse, seed).stand(12, range, range));
      EXPECT_THAT(wide.infrared.refusal, Says("another law")) << range;
      EXPECT_FALSE(wide.infrared.gain.said() || wide.infrared.fall.said()) << range;
    }
    const LogFit narrow = fit_of(mouse, LogSimulator(mouse, seed).stand(12, 8.0, 8.0));
    if (narrow.infrared.refusal.empty()) {
      EXPECT_GT(narrow.infrared.fall.error, exponential.infrared.fall.error);
    }
  }
}

TEST(LogFit, SaysNothingOfWhatTheLogDoesNotTell) {
  const SimulatedMouse mouse;
  const LogFit still = fit_of(mouse, LogSimulator(mouse, 1).stand(4, 5.0, 5.0));
  EXPECT_THAT(still.drive.refusal, Says("moves", "6"));
  EXPECT_THAT(still.infrared.refusal, Says("5 places"));
  EXPECT_THAT(still.count.refusal, Says("way"));
  EXPECT_FALSE(still.drive.gain.said() || still.turn.gain.said() || still.infrared.gain.said());
  const Log bare = log_of("t\n0\n1\n2\n", "time=t");
  const LogFit nothing = fit_log(bare, simulated_hardware(mouse), 90.0, {});
  EXPECT_THAT(nothing.drive.refusal, Says("duties"));
  EXPECT_THAT(nothing.gyro.refusal, Says("gyro"));
  EXPECT_EQ(nothing.error, "");
}

TEST(LogFit, RefusesColumnsThatContradictEachOther) {
  const SimulatedMouse mouse;
  const std::string text = LogSimulator(mouse, 1).drive(40);
  const Log backwards = log_of(text, "time=t,left=l*-1,right=r*-1,left_count=cl,right_count=cr,gyro=g");
  const LogFit fit = fit_log(backwards, simulated_hardware(mouse), 90.0, {});
  EXPECT_THAT(fit.drive.refusal, Says("signs"));
  EXPECT_FALSE(fit.drive.gain.said());
}

/// The rows of a log that are kept, its first line among them.
template <class Kept>
std::string thinned(const std::string& text, Kept kept) {
  std::string thin;
  int line = -1;
  for (std::size_t at = 0; at < text.size(); ++line) {
    const std::size_t end = text.find('\n', at) + 1;
    if (line < 0 || kept(line)) thin += text.substr(at, end - at);
    at = end;
  }
  return thin;
}

/// A log of every fifth row says the same, and so does one whose rows come at uneven times.
TEST(LogFit, ReadsLogsWhoseRowsAreSlowerThanABodyOrUneven) {
  const SimulatedMouse mouse;
  const std::string text = LogSimulator(mouse, 3).drive(60);
  Dice dice(5);
  int next = 0;
  const auto uneven = [&](int line) {
    if (line < next) return false;
    next = line + 1 + dice.below(6);
    return true;
  };
  for (const std::string& thin : {thinned(text, [](int line) { return line % 5 == 0; }), thinned(text, uneven)}) {
    const LogFit fit = fit_of(mouse, thin);
    EXPECT_NEAR(fit.drive.gain.value, mouse.drive.gain, 0.05 * mouse.drive.gain);
    EXPECT_NEAR(fit.turn.gain.value, mouse.turn.gain, 0.05 * mouse.turn.gain);
    EXPECT_NEAR(fit.drive.time.value, mouse.drive.time, 0.1 * mouse.drive.time);
    EXPECT_NEAR(fit.gyro.noise.value, mouse.gyro_noise, 0.25 * mouse.gyro_noise);
  }
}

TEST(CountFit, TakesAKnownWayInPlacesOrAsAWhole) {
  std::string text = "t,l,r,w\n";
  for (int t = 0; t <= 200; ++t)
    text += fmt::format("{},{},{},{}\n", t, 40 * t, 42 * t + (t * 7919) % 5,
                        t % 20 == 0 ? fmt::format("{}", 10.0 * t) : "");
  const Log log = log_of(text, "time=t,left_count=l,right_count=r,way=w");
  const CountFit places = fit_count(log, {});
  EXPECT_EQ(places.refusal, "");
  EXPECT_NEAR(places.count.value, 10.0 / 41.0, 1e-4);
  EXPECT_LT(places.count.error, 2e-4);
  EXPECT_NEAR(places.way, 2000.0, 1e-9);
  const CountFit whole = fit_count(log, {2000.0, 4.0});
  EXPECT_NEAR(whole.count.value, 10.0 / 41.0, 1e-4);
  EXPECT_NEAR(whole.count.error / whole.count.value, 0.002, 1e-4);
  EXPECT_THAT(
      fit_count(log_of("t,l,r,w\n0,0,0,0\n1,2,2,1\n2,4,4,2\n", "time=t,left_count=l,right_count=r,way=w"), {}).refusal,
      Says("3 rows", "6"));
}

TEST(GyroFit, IsLessSureOfNoiseThatIsNotWhite) {
  const auto text_of = [](double memory) {
    Dice dice(7);
    std::string text = "t,l,r,g\n";
    double noise = 0.0;
    for (int t = 0; t < 1000; ++t) {
      noise = memory * noise + 0.01 * NormalNumber::of(dice.bits());
      text += fmt::format("{},0,0,{:.6f}\n", t, 0.05 + noise);
    }
    return text;
  };
  const auto fit = [&](double memory) {
    const Log log = log_of(text_of(memory), "time=t,left=l,right=r,gyro=g");
    return fit_gyro(log, motion_of(log, Hardware()).motion);
  };
  EXPECT_NEAR(fit(0.0).noise.value, 0.01, 2.5 * fit(0.0).noise.error);
  EXPECT_LT(fit(0.0).noise.error, 0.001);
  EXPECT_GT(fit(0.6).noise.error, 2.0 * fit(0.0).noise.error);
}

}  // namespace
}  // namespace labmouse
