// Includes nothing that a microcontroller lacks: the portable checks compile this file with the rooms below the lab.
#include "labmouse/lab/bench/signature.hpp"

#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/maze/generators/generator.hpp"
#include "labmouse/strategies/roster.hpp"

namespace labmouse {
namespace {

/// FNV-1a over numbers.
class Hash {
 public:
  void add_long(std::int64_t number) {
    add(static_cast<int>(number & 0xffffffff));
    add(static_cast<int>(number >> 32));
  }
  void add(int number) {
    const auto bits = static_cast<std::uint32_t>(number);
    for (unsigned shift = 0; shift < 32; shift += 8) hash_ = (hash_ ^ (bits >> shift & 0xFFU)) * 0x100000001B3U;
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325U;
};

void add_contest(const Maze& maze, const RosterEntry& mouse, Hash& hash) {
  const Rules rules;
  const auto mind = mouse.make(brief(maze, rules, 1), Settings(mouse.parameters));
  const RunRecord record = run(maze, rules, *mind);
  for (const StepRecord& step : record.steps) {
    hash.add(static_cast<int>(step.action.kind));
    hash.add(step.action.rotation);
    hash.add(step.action.movement);
  }
  hash.add(static_cast<int>(record.outcome));
}

/// A robot of one speed, and one whose turns follow from its limits.
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
    for (const RosterEntry* mouse : roster()) {
      if (!mouse->drives) continue;
      const auto mind = mouse->make(brief(maze, rules, model, 1), Settings(mouse->parameters));
      const DriveRecord record = drive(maze, rules, model, *mind);
      for (const DriveRun& run : record.runs) add_run(run, hash);
      hash.add(static_cast<int>(record.outcome));
    }
  }
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
      for (const RosterEntry* mouse : roster()) add_contest(maze, *mouse, hash);
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
        // A robot of many speeds takes its time to plan.
        if (!generator->refuses(order).empty() || (!one_speed && size.width > 7)) continue;
        add_drives(generator->make(order), model, hash);
      }
  }
  return hash.value();
}

std::string signature() { return hexadecimal(behaviour_signature()) + "-" + hexadecimal(seconds_signature()); }

}  // namespace labmouse
