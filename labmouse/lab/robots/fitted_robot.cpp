#include "labmouse/lab/robots/fitted_robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "labmouse/lab/robots/remarked_robot.hpp"
#include "labmouse/lab/robots/robot_file.hpp"
#include "labmouse/lab/text/numbers.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/mouse/robot/fitted_turn.hpp"
#include "labmouse/mouse/robot/straights.hpp"

namespace labmouse {
namespace {

/// Five digits are as much as published turns tell.
double rounded(double value) { return labmouse::rounded(value, 5); }

std::string from_base(const Robot& base) { return fmt::format("from {}: turns do not determine it", shown(base.name)); }

std::string key_of(std::string_view section, Turn turn) { return fmt::format("{}.{}", section, name_of(turn)); }

/// The distance that the given paths keep from posts and walls.
double clearance_of(const Robot& robot, const std::vector<KnownTurn>& turns) {
  double least = robot.cell;
  for (const KnownTurn& turn : turns)
    if (!turn.wide && turn.speed > 0.0 && turn.turn != Turn::f180)
      least = std::min(least, turn_laid_out_for(turn.speed, turn.turn, robot).shape.clearance);
  return std::max(0.0, std::floor(least * 10.0 - 1.0) / 10.0);
}

/// A robot as it was fitted, and what speaks against it.
FittedRobot checked(std::string text, double worst_error) {
  constexpr double close = 0.01;
  FittedRobot fitted{std::move(text), "", ""};
  if (const RobotResult read = read_robot(fitted.text, "it"); !read.problems.empty())
    fitted.doubt = fmt::format("the robot is refused as it stands: {}", read.problems.front().reason);
  else if (worst_error > close)
    fitted.doubt = fmt::format("the limits miss a turn by {:.1f} %: are all turns of one robot, and the units right?",
                               worst_error * 100.0);
  if (!fitted.doubt.empty()) fitted.text = fmt::format("# {}\n{}", fitted.doubt, fitted.text);
  return fitted;
}

std::string limit_remark(bool reached, const TurnFit& fit) {
  if (!reached) return "no turn reaches it; it may be anything above";
  return fit.figures < fit.numbers
             ? fmt::format("one of many answers: {} limits from {} figures", fit.numbers, fit.figures)
             : "fitted";
}

FittedRobot by_limits(const std::vector<KnownTurn>& turns, const Robot& base, double cell) {
  const TurnFit fit = fit_turns(turns, cell);
  if (fit.numbers == 0)
    return {{}, "no limits follow from these turns; are speeds in mm/s, lengths in mm and times in ms?", {}};
  Robot robot = base;
  robot.cell = cell;
  robot.layouts = {};
  robot.yaw_acceleration = rounded(fit.limits.yaw_acceleration);
  robot.yaw_speed = rounded(fit.limits.yaw_speed);
  robot.yaw_jerk = rounded(fit.limits.yaw_jerk);
  robot.lateral_acceleration = rounded(fit.limits.lateral_acceleration);
  KeyRemarks remarks = {{"cell", cell == base.cell ? from_base(base) : "given"},
                        {"clearance", "what the paths below keep"},
                        {"curve.lateral_acceleration", limit_remark(fit.reaches_lateral, fit)},
                        {"curve.yaw_acceleration", limit_remark(fit.reaches_acceleration, fit)},
                        {"curve.yaw_speed", limit_remark(fit.reaches_speed, fit)},
                        {"curve.yaw_jerk", limit_remark(fit.reaches_jerk, fit)}};
  double hardest = 0.0;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const KnownTurn& turn = turns[i];
    if (turn.speed <= 0.0) continue;
    hardest =
        std::max(hardest, turn.speed * turn.speed *
                              shape_at(turn.turn, turn.speed, fit.limits, turn.wide ? 2.0 * cell : cell).ramp.peak);
    const double given = turn.turn == Turn::f180 ? turn.before : turn.speed;
    if (turn.wide || given <= 0.0) continue;
    robot.layouts[static_cast<unsigned>(turn.turn)].given = given;
    remarks[key_of("layout", turn.turn)] = fmt::format("given; the limits miss it by {:.3f} %", fit.errors[i] * 100.0);
  }
  if (!fit.reaches_lateral) robot.lateral_acceleration = std::ceil(hardest / 100.0) * 100.0;
  robot.clearance = clearance_of(robot, turns);
  const double small = robot.layout(Turn::s90).given;
  if (robot.search.cell == 0 && robot.search_turn_speed <= 0.0 && small > 0.0 && robot.search_speed > small) {
    robot.search_speed = small;
    remarks["search.speed"] = "that of S90: as fast as the other robot it could not turn";
  }
  return checked(remarked_robot(robot, RobotParts::limits, remarks, from_base(base)),
                 *std::max_element(fit.errors.begin(), fit.errors.end()));
}

FittedRobot by_times(const std::vector<KnownTurn>& turns, const Robot& base, double cell) {
  Robot robot = base;
  robot.cell = cell;
  KeyRemarks remarks = {{"cell", cell == base.cell ? from_base(base) : "given"}};
  for (const KnownTurn& turn : turns) {
    if (turn.wide) continue;
    FixedTimes& fixed = *robot.fixed;
    const std::array times = {&fixed.f45, &fixed.f90, &fixed.f135, &fixed.f180, &fixed.v90, &fixed.s90};
    *times[static_cast<unsigned>(turn.turn)] = microseconds(turn.milliseconds / 1e3);
    remarks[key_of("turns", turn.turn)] = "given";
  }
  return checked(remarked_robot(robot, RobotParts::limits, remarks, from_base(base)), 0.0);
}

}  // namespace

double cell_of(const std::vector<KnownTurn>& turns) {
  for (const KnownTurn& turn : turns)
    if (turn.turn == Turn::s90 && turn.aside > 0.0 && turn.before > 0.0) return 2.0 * (turn.aside + turn.before);
  return 0.0;
}

FittedRobot fitted_robot(const std::vector<KnownTurn>& turns, const Robot& base, double cell) {
  const bool speeds = std::any_of(turns.begin(), turns.end(), [](const KnownTurn& turn) { return turn.speed > 0.0; });
  if (speeds && base.fixed)
    return {{},
            fmt::format("'{}' gives the times of its turns, and the table has speeds; take the rest from a robot with "
                        "limits, such as classic or kerise",
                        shown(base.name)),
            {}};
  if (!speeds && !base.fixed)
    return {{},
            fmt::format("the table has times without speeds, which tell nothing of limits, and '{}' has limits; take "
                        "the rest from a robot with times of turns, such as mm2021",
                        shown(base.name)),
            {}};
  return speeds ? by_limits(turns, base, cell) : by_times(turns, base, cell);
}

}  // namespace labmouse
