#include "labmouse/controller/speed_control.hpp"

namespace labmouse {

SpeedControl::SpeedControl(const Hardware& hardware, double cell)
    : hardware_(hardware), gains_(gains_each_tick(hardware, cell)), axes_(gains_, hardware.motors) {}

void SpeedControl::rest() {
  axes_.reset();
  counts_.reset();
  speed_ = turning_ = 0.0;
}

void SpeedControl::measure(const Sense& sense) {
  const Sensors& sensors = hardware_.sensors;
  std::array<double, 2> ways{};  // of the wheels since the last tick, mm
  if (counts_)
    for (std::size_t wheel = 0; wheel < 2; ++wheel)
      ways[wheel] = sensors.count * wrapped(static_cast<std::uint32_t>(sense.counts[wheel]) -
                                                static_cast<std::uint32_t>((*counts_)[wheel]),
                                            sensors.count_bits);
  counts_ = sense.counts;
  const auto smooth = [&](double& measured, double now) { measured += gains_.speed_filter * (now - measured); };
  smooth(speed_, (ways[0] + ways[1]) / 2.0 / tick_seconds);
  if (sensors.has_gyro())
    turning_ = sense.gyro * sensors.gyro_step;
  else
    smooth(turning_, (ways[1] - ways[0]) / (2.0 * hardware_.chassis.half_track) / tick_seconds);
}

Drive SpeedControl::control(double speed, double turning, const Sense& sense) {
  measure(sense);
  return axes_.control({.speed = speed, .turning = turning}, speed_, turning_, sense.millivolts / 1e3);
}

}  // namespace labmouse
