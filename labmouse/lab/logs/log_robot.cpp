#include "labmouse/lab/logs/log_robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "labmouse/lab/logs/log_fit.hpp"
#include "labmouse/lab/robots/hardware_keys.hpp"
#include "labmouse/lab/robots/remarked_robot.hpp"
#include "labmouse/lab/robots/robot_file.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/numbers.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// The robot that grows of a log: its numbers with their remarks, and the lines at the head of its file.
class LogRobot {
 public:
  LogRobot(const Log& log, std::string_view log_name, const Robot& base)
      : log_(log), robot_(base), from_base_(fmt::format("from {}", shown(base.name))) {
    head_ = fmt::format("# Fitted to {}; all else is from {}. +- is a standard error.\n", shown(log_name),
                        shown(base.name));
  }

  void add(const LogFit& fit) {
    add_rows(fit.seconds);
    add_count(fit.count);
    add_motor("driving", "motors.drive", fit.drive, "mm/s", has(LogRole::left) && counts());
    add_motor("turning", "motors.turn", fit.turn, "rad/s", has(LogRole::left) && (counts() || has(LogRole::gyro)));
    if (fit.turn.mixed.said() && std::abs(fit.turn.mixed.value) > 2.0 * fit.turn.mixed.error)
      head_ +=
          fmt::format("# the right motor is {:.1f} % {} than the left one, +- {:.2g} %; a robot's motors are alike\n",
                      100.0 * std::abs(fit.turn.mixed.value), fit.turn.mixed.value > 0.0 ? "stronger" : "weaker",
                      100.0 * fit.turn.mixed.error);
    add_gyro(fit.gyro);
    add_infrared(fit.infrared);
  }

  FittedRobot result() const {
    FittedRobot fitted;
    fitted.doubt = doubt_;
    fitted.text =
        head_ + "\n" +
        remarked_robot(robot_, RobotParts::with_body, remarks_, from_base_ + ": the log does not determine it");
    if (const RobotResult read = read_robot(fitted.text, "it"); !read.problems.empty() && fitted.doubt.empty())
      fitted.doubt = fmt::format("the robot is refused as it stands: {}", read.problems.front().reason);
    return fitted;
  }

 private:
  bool has(LogRole role) const { return log_.has(role); }
  bool counts() const { return has(LogRole::left_count) || has(LogRole::left_speed); }

  /// A number of the file, where the log says it and a file may have it.
  void set(std::string_view name, const Estimate& estimate, const std::string& more = "") {
    if (!estimate.said()) return;
    for (const HardwareKey& key : hardware_keys()) {
      if (key.key.name != name) continue;
      // Five digits are more than a log tells.
      const double value = rounded(estimate.value * key.unit, 5);
      if (!(value >= key.key.low && value <= key.key.high)) {
        remarks_[std::string(name)] = fmt::format("{}: the log says {:g}, which it cannot be", from_base_, value);
        return;
      }
      key.number(*robot_.hardware) = value / key.unit;
      remarks_[std::string(name)] = fmt::format("fitted, +- {:.2g}{}", estimate.error * key.unit, more);
    }
  }

  /// A line at the head: how well a part fits, or why it does not; that is doubtful where the log was to tell it.
  void tell(std::string_view part, const std::string& refusal, bool asked, const std::string& fit) {
    head_ += fmt::format("# {}: {}\n", part, refusal.empty() ? fit : "nothing fitted, " + refusal);
    if (asked && !refusal.empty() && doubt_.empty()) doubt_ = fmt::format("{}: {}", part, refusal);
  }

  /// What stands between rows is not known, so it matters how far apart they are.
  void add_rows(double seconds) {
    double most = 0.0;
    for (std::size_t row = 1; row < log_.times.size(); ++row)
      most = std::max(most, log_.times[row] - log_.times[row - 1]);
    const double mean = 1e3 * seconds / static_cast<double>(log_.times.size() - 1);
    head_ += fmt::format("# log: {:.3g} s; rows are {:.3g} ms apart{}\n", seconds, mean,
                         most > 1.5 * mean ? fmt::format(", where some are missing {:.3g} ms", most) : "");
  }

  void add_count(const CountFit& fit) {
    const bool asked = has(LogRole::way) || fit.way > 0.0;
    tell("encoders", fit.refusal, asked,
         fit.missed > 0.0 ? fmt::format("{:.0f} mm known; misses places left out by {:.2g} mm", fit.way, fit.missed)
                          : fmt::format("{:.0f} mm known as a whole, so that nothing could be left out", fit.way));
    set("sensors.count", fit.count);
  }

  void add_motor(std::string_view part, const std::string& axis, const MotorFit& fit, std::string_view unit,
                 bool asked) {
    std::string words = fmt::format(
        "{} of moving; misses the speed on those left out by {:.2g} of {:.4g} {} ({:.1f} %)"
        ", {:.2g} of it noise",
        counted(static_cast<std::int64_t>(fit.stretches), "stretch", "stretches"), fit.missed, fit.peak, unit,
        fit.peak > 0.0 ? 100.0 * fit.missed / fit.peak : 0.0, std::min(fit.noise, fit.missed));
    if (fit.lag != 0.0)
      words += fmt::format("; a lag of {:.1f} ms fits better: errors hold what it would change", 1e3 * fit.lag);
    if (fit.drag != 0.0) words += "; drag that grows with the speed fits better: errors hold what it would change";
    tell(part, fit.refusal, asked, words);
    set(axis + "_gain", fit.gain, fit.time_known ? "" : ", for the time below");
    set(axis + "_time", fit.time);
    set(axis + "_dead_zone", fit.dead_zone);
    set("motors.turning", fit.taking);
    if (fit.gain.said() && !fit.time_known)
      remarks_[axis + "_time"] = from_base_ + ": the log does not tell it from the gain";
  }

  void add_gyro(const GyroFit& fit) {
    tell("gyro", fit.refusal, has(LogRole::gyro),
         fmt::format("{:.2g} s at rest; quarters of it left out differ by {:.1f} %", fit.rest, 100.0 * fit.missed));
    set("noise.gyro", fit.noise);
  }

  void add_infrared(const InfraredFit& fit) {
    const bool asked = has(LogRole::wall_right) || has(LogRole::wall_left) || has(LogRole::wall_ahead);
    std::string gains;
    constexpr std::array<std::string_view, beam_count> names = {"right", "right ahead", "left", "left ahead"};
    for (std::size_t beam = 0; beam < beam_count; ++beam)
      if (fit.of_beam[beam] > 0.0)
        gains += fmt::format("{}{} {:.3g}", gains.empty() ? "" : ", ", names[beam], fit.of_beam[beam]);
    tell("infrared", fit.refusal, asked,
         fmt::format("{}; misses readings at those left out by {:.1f} %; {}{}",
                     counted(static_cast<std::int64_t>(fit.places), "place", "places"), 100.0 * fit.missed, gains,
                     fit.bends ? "; readings follow another law: errors hold what that would change" : ""));
    set("sensors.infrared_gain", fit.gain);
    set("sensors.infrared_fall", fit.fall);
  }

  const Log& log_;
  Robot robot_;
  std::string from_base_;
  std::string head_;
  KeyRemarks remarks_;
  std::string doubt_;
};

}  // namespace

FittedRobot robot_by_log(const Log& log, std::string_view log_name, const Robot& base, const WholeWay& whole) {
  FittedRobot none;
  if (!base.hardware) {
    none.error = fmt::format(
        "'{}' does not say what it is built of; take the rest from a robot that does, such as classic or kerise",
        shown(base.name));
    return none;
  }
  const LogFit fit = fit_log(log, *base.hardware, base.cell, whole);
  if (!fit.error.empty()) {
    none.error = fit.error;
    return none;
  }
  LogRobot robot(log, log_name, base);
  robot.add(fit);
  return robot.result();
}

}  // namespace labmouse
