// Includes nothing that a microcontroller lacks: this file is also compiled for one, with the modules outside of lab/.
#include "labmouse/lab/bench/signature.hpp"

#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/known_drive.hpp"
#include "labmouse/contest/physical.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/functions/bits.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {
namespace {

/// FNV-1a over numbers.
class Hash {
 public:
  void add_long(std::int64_t number) {
    add(static_cast<int>(number & 0xffffffff));
    add(static_cast<int>(number >> 32));
  }
  /// Adds all 64 bits.
  void add_number(double number) { add_long(bits_as<std::int64_t>(number)); }
  void add(int number) {
    const auto bits = static_cast<std::uint32_t>(number);
    for (unsigned shift = 0; shift < 32; shift += 8) hash_ = (hash_ ^ (bits >> shift & 0xFFU)) * 0x100000001B3U;
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325U;
};

void add_contest(const Maze& maze, const BuiltinMouse& mouse, Hash& hash) {
  const Rules rules;
  const auto strategy = mouse.make(brief(maze, rules, 1), Settings(mouse.parameters));
  const RunRecord record = run(maze, rules, *strategy);
  for (const StepRecord& step : record.steps) {
    hash.add(static_cast<int>(step.action.kind));
    hash.add(step.action.rotation);
    hash.add(step.action.movement);
  }
  hash.add(static_cast<int>(record.outcome));
}

/// A robot with fixed times (one speed), or one whose times follow from its limits.
Robot robot(bool one_speed) {
  Robot robot;
  robot.cell = 90.0;
  robot.speed = 1500.0;
  robot.speed_diagonal = 1200.0;
  robot.acceleration = robot.braking = 4200.0;
  robot.acceleration_diagonal = robot.braking_diagonal = 3600.0;
  robot.search = {300'000, 237'000, 3'000'000, 1'500'000, 300'000};
  if (one_speed) {
    robot.fixed = FixedTimes{420.0, 257'000, 375'000, 465'000, 563'000, 388'000, 280'000};
    return robot;
  }
  robot.lateral_acceleration = 3800.0;
  robot.yaw_acceleration = 300.0;
  robot.clearance = 18.0;
  robot.run_up = 24.0;
  return robot;
}

void add_run(const DriveRun& run, Hash& hash) {
  hash.add(static_cast<int>(run.kind));
  hash.add_long(run.end);
  for (const SearchMove& move : run.moves) {
    hash.add_long(move.end);
    hash.add(move.action.rotation);
    hash.add(move.action.movement);
  }
  for (const DriveSegment& segment : run.route.segments) {
    hash.add(segment.end);
    hash.add(segment.turn);
    hash.add(segment.units);
  }
}

void add_drives(const Maze& maze, const DriveModel& model, Hash& hash) {
  for (const int divisor : {0, 30}) {
    DriveRules rules;
    rules.time_limit = 600'000'000;
    rules.maze_time_divisor = divisor;
    for (const BuiltinMouse* mouse : builtin_mice()) {
      if (!mouse->drives()) continue;
      const auto strategy = mouse->drive(brief(maze, rules, model, 1), Settings(mouse->parameters));
      const DriveRecord record = drive(maze, rules, model, *strategy);
      for (const DriveRun& run : record.runs) add_run(run, hash);
      hash.add(static_cast<int>(record.outcome));
    }
  }
}

/// Hardware with every kind of sensor and noise.
Hardware hardware() {
  Hardware all;
  all.chassis = {26.0, 16.0, 17.0, 15.0};
  all.motors = {{3000.0, 0.125, 0.0625}, {80.0, 0.1, 0.05}, 0.002, 0.15, 0.05, 0.001, 4.0};
  all.tyres = {100'000.0, 9000.0, 3000.0, 0.005};
  Sensors& sensors = all.sensors;
  sensors.count = 0.001;
  sensors.gyro_step = 0.001;
  sensors.gyro_most = 35.0;
  sensors.acceleration_step = 5.0;
  for (const Beam& beam : {Beam{12, -12, -1.16}, Beam{20, -8, -0.09}, Beam{12, 12, 1.16}, Beam{20, 8, 0.09}})
    sensors.infrared.push_back({beam, 700.0, 12.9, 3600.0, 5.0});
  sensors.rangers = {{{20.0, 0.0, 0.0}, 255.0, 11.0}};
  Noise& noise = all.noise;
  noise.gyro_bias = 0.002;
  noise.ripple = 0.1;
  noise.ripple_length = 12.5;
  noise.encoder = 0.015;
  noise.gyro = 0.003;
  noise.gyro_walk = 0.0003;
  noise.acceleration = 350.0;
  noise.infrared = 3.0;
  noise.infrared_share = 0.005;
  noise.infrared_memory = 0.4;
  noise.ranger_rest = 1.5;
  noise.ranger = 3.0;
  noise.shaking = 0.25;
  noise.shaking_speed = 300.0;
  noise.shaking_pitch = 100.0;
  noise.shaking_loss = 0.25;
  all.variation = {.motor_gain = 0.1,
                   .battery = 0.05,
                   .stiffness = 0.3,
                   .grip = 0.15,
                   .encoder_scale = 0.01,
                   .gyro_scale = 0.01,
                   .acceleration_bias = 300.0,
                   .infrared_gain = 0.15,
                   .reflectance = 0.1,
                   .maze_reflectance = 0.1,
                   .post_shift = 1.0,
                   .ambient = 30.0,
                   .ambient_drift = 2.0,
                   .dust = 0.15,
                   .floor_steps = 0.05,
                   .floor_turn = 0.01,
                   .floor_shift = 0.5,
                   .floor_tilt = 0.01,
                   .placement = 1.0,
                   .placement_turn = 0.0175};
  return all;
}

void add_known_drive(const KnownDrive& drive, Hash& hash) {
  hash.add(drive.crashed ? 1 : 0);
  hash.add_long(drive.ticks);
  for (const WayErrors* errors : {&drive.truth, &drive.estimate})
    for (const double sum : {errors->along, errors->aside, errors->direction}) hash.add_number(sum);
  for (const WallReadings* readings : {&drive.side, &drive.front}) hash.add_long(readings->wrong);
}

void add_physical_contest(const Maze& maze, const DriveModel& model, const PhysicalConditions& conditions, Hash& hash) {
  DriveRules rules;
  rules.time_limit = 60'000'000;
  const BuiltinMouse& mouse = *find_mouse("flood-return");
  Briefing briefing = brief(maze, rules, model, 1);
  briefing.sight = 1;
  const auto strategy = mouse.drive(briefing, Settings(mouse.parameters));
  const PhysicalRecord record = drive_physically(maze, rules, model, conditions, 1, *strategy);
  for (const DriveRun& run : record.drive.runs) add_run(run, hash);
  for (const RunEnd end : record.ends) hash.add(static_cast<int>(end));
  for (const TracePoint& point : record.trace)
    for (const BodyPose& pose : {point.truth, point.estimate.value_or(point.truth)})
      for (const double number : {pose.position.x, pose.position.y, pose.angle}) hash.add_number(number);
}

/// Sixteen hexadecimal digits.
std::string hexadecimal(std::uint64_t number) {
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4) text += "0123456789abcdef"[number >> shift & 0xfU];
  return text;
}

}  // namespace

std::uint64_t behaviour_signature() {
  Hash hash;
  for (const Generator* generator : all_generators())
    for (const Size size : {Size{7, 5}, Size{16, 16}, Size{32, 32}, Size{40, 64}}) {
      const GeneratorOrder order{size, 1, 100};
      if (!generator->refuses(order).empty()) continue;
      const Maze maze = generator->make(order);
      for (const BuiltinMouse* mouse : builtin_mice()) add_contest(maze, *mouse, hash);
    }
  return hash.value();
}

std::uint64_t seconds_signature() {
  Hash hash;
  for (const bool one_speed : {true, false}) {
    const DriveModel model = make_drive_model(robot(one_speed));
    hash.add_long(static_cast<std::int64_t>(model.tables.hash));
    for (const Generator* generator : all_generators())
      for (const Size size : {Size{7, 5}, Size{16, 16}}) {
        const GeneratorOrder order{size, 1, 100};
        // Planning for a robot of many speeds is slow, so it drives in small mazes only.
        if (!generator->refuses(order).empty() || (!one_speed && size.width > 7)) continue;
        add_drives(generator->make(order), model, hash);
      }
  }
  return hash.value();
}

std::uint64_t physical_signature() {
  Hash hash;
  Robot built = robot(false);
  built.hardware = hardware();
  DriveModel model = make_drive_model(built);
  share_route_tables(model);
  for (const double scale : {0.0, 1.0, 3.0})
    for (const Generator* generator : all_generators()) {
      const GeneratorOrder order{Size{7, 5}, 1, 100};
      if (!generator->refuses(order).empty()) continue;
      const Maze maze = generator->make(order);
      PhysicalConditions conditions;
      conditions.errors.noise = conditions.errors.variation = scale;
      conditions.trace_every = 100;
      for (const KnownWay way : {KnownWay::search, KnownWay::fast})
        if (const auto drive = drive_known_way(maze, model, conditions, way, 1)) add_known_drive(*drive, hash);
      add_physical_contest(maze, model, conditions, hash);
    }
  return hash.value();
}

std::string signature() {
  return hexadecimal(behaviour_signature()) + "-" + hexadecimal(seconds_signature()) + "-" +
         hexadecimal(physical_signature());
}

}  // namespace labmouse
