#include "labmouse/lab/logs/log_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "labmouse/hardware/sense.hpp"

namespace labmouse {
namespace {

constexpr double tick_ms = 1000.0 * tick_seconds;
/// A mouse that moves faster is none: its counter has wrapped.
constexpr double most_speed = 30'000.0;  // mm/s

/// The rows of a log at ticks.
class Ticks {
 public:
  explicit Ticks(const std::vector<double>& times) : times_(times) {
    // A tick that a rounding of the times leaves a little before its row is that row's.
    constexpr double slack = 1e-3;
    const auto count = static_cast<std::size_t>((times.back() + slack) / tick_ms) + 1;
    rows_.reserve(count);
    std::size_t row = 0;
    for (std::size_t tick = 0; tick < count; ++tick) {
      while (row + 1 < times.size() && times[row + 1] <= static_cast<double>(tick) * tick_ms + slack) ++row;
      rows_.push_back(row);
    }
  }

  std::size_t count() const { return rows_.size(); }

  /// What stands in the row before each tick.
  std::vector<double> held(std::span<const double> values) const {
    std::vector<double> held;
    held.reserve(rows_.size());
    for (const std::size_t row : rows_) held.push_back(values[row]);
    return held;
  }

  /// On the line between the rows about each tick.
  std::vector<double> between(std::span<const double> values) const {
    std::vector<double> between;
    between.reserve(rows_.size());
    for (std::size_t tick = 0; tick < rows_.size(); ++tick) {
      const std::size_t row = rows_[tick], next = std::min(row + 1, values.size() - 1);
      const double step = times_[next] - times_[row], late = static_cast<double>(tick) * tick_ms - times_[row];
      const double share = step > 0.0 ? std::max(0.0, late / step) : 0.0;
      between.push_back(values[row] + share * (values[next] - values[row]));
    }
    return between;
  }

 private:
  const std::vector<double>& times_;
  std::vector<std::size_t> rows_;
};

/// Of speeds, tick by tick, as a body adds them up.
std::vector<double> sums_of(std::vector<double> rates) {
  double sum = 0.0;
  for (std::size_t tick = 0; tick < rates.size(); ++tick) {
    if (tick > 0) sum += rates[tick] * tick_seconds;
    rates[tick] = sum;
  }
  return rates;
}

void scale(std::vector<double>& values, double factor) {
  for (double& value : values) value *= factor;
}

/// How far each wheel has come.
struct Wheels {
  std::vector<double> left, right;
};

Wheels wheels_of(const Log& log, const Ticks& ticks, const Hardware& hardware) {
  Wheels wheels;
  if (log.has(LogRole::left_count)) {
    wheels = {ticks.between(log.of(LogRole::left_count)), ticks.between(log.of(LogRole::right_count))};
    scale(wheels.left, hardware.sensors.count);
    scale(wheels.right, hardware.sensors.count);
  } else if (log.has(LogRole::left_speed)) {
    wheels = {sums_of(ticks.between(log.of(LogRole::left_speed))),
              sums_of(ticks.between(log.of(LogRole::right_speed)))};
  }
  return wheels;
}

/// What the motors get of their duties: by the battery as it was, or as the hardware says that it yields.
void add_duties(LogMotion& motion, const Log& log, const Ticks& ticks, const Motors& motors) {
  if (!log.has(LogRole::left)) return;
  motion.left = ticks.held(log.of(LogRole::left));
  motion.right = ticks.held(log.of(LogRole::right));
  const std::vector<double> volts =
      log.has(LogRole::volts) ? ticks.between(log.of(LogRole::volts)) : std::vector<double>();
  for (std::size_t tick = 0; tick < motion.ticks; ++tick) {
    const double load = (std::abs(motion.left[tick]) + std::abs(motion.right[tick])) / 2.0;
    // The voltage under this tick's duties is read with the next row.
    const double share =
        volts.empty() ? 1.0 - motors.sag * load : volts[std::min(tick + 1, motion.ticks - 1)] / motors.volts;
    motion.left[tick] *= share;
    motion.right[tick] *= share;
  }
}

/// Where neither wheels nor body move and no motor is driven.
std::vector<TickSpan> rests_of(const LogMotion& motion, double count) {
  constexpr std::size_t about = 25, least = 100;
  const double still = std::max(0.15, 2.0 * count);  // mm
  constexpr double turned = 0.01, pushed = 0.01;     // rad, duty
  if (motion.way.empty() && motion.left.empty()) return {};
  const auto stays = [](const std::vector<double>& places, std::size_t from, std::size_t to, double most) {
    return places.empty() || std::abs(places[to] - places[from]) <= most;
  };
  std::vector<TickSpan> rests;
  TickSpan rest;
  const auto close = [&] {
    if (rest.size() >= least) rests.push_back(rest);
    rest = {};
  };
  for (std::size_t tick = about; tick + about < motion.ticks; ++tick) {
    const bool driven = !motion.left.empty() && std::abs(motion.left[tick]) + std::abs(motion.right[tick]) > pushed;
    const bool rests_now = !driven && stays(motion.way, tick - about, tick + about, still) &&
                           stays(motion.angle, tick - about, tick + about, turned);
    if (!rests_now) {
      close();
    } else {
      if (rest.size() == 0) rest.begin = tick;
      rest.end = tick + 1;
    }
  }
  close();
  return rests;
}

/// Takes what the gyro shows at rest out of the angles.
void level_out(LogMotion& motion) {
  double turned = 0.0, ticks = 0.0;
  for (const TickSpan& rest : motion.rests) {
    turned += motion.angle[rest.end - 1] - motion.angle[rest.begin];
    ticks += static_cast<double>(rest.size() - 1);
  }
  if (ticks == 0.0) return;
  for (std::size_t tick = 0; tick < motion.ticks; ++tick)
    motion.angle[tick] -= static_cast<double>(tick) * turned / ticks;
}

/// Where a wheel goes faster than any: there a counter has wrapped, or the log has a fault.
std::string jump_in(const std::vector<double>& wheel, std::string_view name) {
  for (std::size_t tick = 1; tick < wheel.size(); ++tick)
    if (const double step = wheel[tick] - wheel[tick - 1]; std::abs(step) > most_speed * tick_seconds)
      return fmt::format(
          "the {} wheel goes {:.0f} mm in a millisecond at {} ms; does its counter wrap? then say where, as in "
          "{}_count=NAME%65536; or else the robot's sensors.count is not that of this mouse",
          name, step, tick, name);
  return "";
}

}  // namespace

LogMotionResult motion_of(const Log& log, const Hardware& hardware) {
  LogMotionResult result;
  LogMotion& motion = result.motion;
  const Ticks ticks(log.times);
  motion.ticks = ticks.count();
  const Wheels wheels = wheels_of(log, ticks, hardware);
  for (const auto& [wheel, name] : {std::pair(&wheels.left, "left"), std::pair(&wheels.right, "right")})
    if (result.error = jump_in(*wheel, name); !result.error.empty()) return result;
  for (std::size_t tick = 0; tick < wheels.left.size(); ++tick)
    motion.way.push_back((wheels.left[tick] + wheels.right[tick]) / 2.0);
  add_duties(motion, log, ticks, hardware.motors);
  motion.by_gyro = log.has(LogRole::gyro);
  if (motion.by_gyro) {
    motion.angle = sums_of(ticks.between(log.of(LogRole::gyro)));
  } else {
    for (std::size_t tick = 0; tick < wheels.left.size(); ++tick)
      motion.angle.push_back((wheels.right[tick] - wheels.left[tick]) / (2.0 * hardware.chassis.half_track));
  }
  motion.rests = rests_of(motion, hardware.sensors.count);
  if (motion.by_gyro) level_out(motion);
  return result;
}

std::vector<double> rates_of(const std::vector<double>& places, std::size_t about) {
  std::vector<double> rates(places.size(), 0.0);
  for (std::size_t tick = 0; tick < places.size(); ++tick) {
    const std::size_t from = tick - std::min(tick, about), to = std::min(tick + about, places.size() - 1);
    if (to > from) rates[tick] = (places[to] - places[from]) / (static_cast<double>(to - from) * tick_seconds);
  }
  return rates;
}

}  // namespace labmouse
