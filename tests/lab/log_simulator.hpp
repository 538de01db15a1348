// A mouse of a few lines that writes logs: not the body of the physical world, so that what is fitted to its logs is
// not fitted to itself. Its motors may be of the second order, and its infrared sensors may follow another law.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string>

#include "labmouse/chance/dice.hpp"

namespace labmouse::test {

struct SimulatedAxis {
  double gain, time, dead_zone;
};

struct SimulatedMouse {
  SimulatedAxis drive = {3000.0, 0.15, 0.06}, turn = {90.0, 0.12, 0.05};
  double second_time = 0.0;  ///< s that the current of a motor takes to follow its duty
  double count = 0.1;        ///< mm
  double half_track = 20.0;  ///< mm
  double gyro_noise = 0.004;
  double ir_gain = 500.0, ir_fall = 14.0;
  bool inverse_square = false;  ///< with an offset, in place of an exponential
  double face = 42.0;           ///< mm from its middle to a wall in the middle of a cell
};

/// Half a second of rest, then so many moves under steady duties, with some of infrared at known distances if so many
/// places are asked for. Columns: t (ms), l, r, cl, cr, g, ir, wall.
class LogSimulator {
 public:
  LogSimulator(const SimulatedMouse& mouse, std::uint64_t seed) : mouse_(mouse), dice_(seed) {}

  std::string drive(int moves) {
    rest(500);
    for (int move = 0; move < moves; ++move) {
      const double onwards = 0.12 + 0.3 * uniform(), around = 0.3 * (uniform() - 0.5);
      run(200 + dice_.below(300), onwards - around / 2.0, onwards + around / 2.0);
      if (move % 5 == 4) run(300, 0.0, 0.0);
    }
    return std::move(text_);
  }

  /// At rest at places from so much nearer to so much farther than the middle of a cell, in mm.
  std::string stand(int places, double nearer, double farther) {
    for (int place = 0; place < places; ++place) {
      wall_ = mouse_.face - nearer + (nearer + farther) * place / (places - 1);
      // A ruler is read to a fifth of a mm, and no two places of a wall reflect alike.
      true_wall_ = wall_ + 0.2 * normal();
      reflectance_ = 1.0 + 0.02 * normal();
      rest(100);
    }
    return std::move(text_);
  }

 private:
  double uniform() { return static_cast<double>(dice_.bits() >> 11U) / 9007199254740992.0; }
  double normal() {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += uniform();
    return sum;
  }

  static void push(const SimulatedAxis& axis, double current, double& rate, double step) {
    // Friction holds what it can, and takes the rest.
    const double free = rate + step / axis.time * (axis.gain * current - rate);
    const double friction = step / axis.time * axis.gain * axis.dead_zone;
    rate = free > friction ? free - friction : free < -friction ? free + friction : 0.0;
  }

  void rest(int ticks) { run(ticks, 0.0, 0.0); }

  void run(int ticks, double left, double right) {
    for (int i = 0; i < ticks; ++i) {
      write(left, right);
      // Ten steps a tick, so that no tick of ours is in it.
      constexpr int steps = 10;
      const double step = 0.001 / steps;
      for (int j = 0; j < steps; ++j) {
        const double follow = mouse_.second_time > 0.0 ? std::min(1.0, step / mouse_.second_time) : 1.0;
        onwards_ += follow * ((left + right) / 2.0 - onwards_);
        around_ += follow * (right - left - around_);
        push(mouse_.drive, onwards_, speed_, step);
        push(mouse_.turn, around_, turning_, step);
        travel_[0] += (speed_ - mouse_.half_track * turning_) * step;
        travel_[1] += (speed_ + mouse_.half_track * turning_) * step;
      }
    }
  }

  double reading() {
    const double farther = true_wall_ - mouse_.face;
    double level = mouse_.ir_gain * std::exp(-farther / mouse_.ir_fall);
    if (mouse_.inverse_square) {
      constexpr double near = 28.0;  // mm in which it would grow beyond all bounds
      level = mouse_.ir_gain * near * near / ((near + farther) * (near + farther)) + 60.0;
    }
    return std::max(0.0, std::round(reflectance_ * level + 3.0 * normal()));
  }

  void write(double left, double right) {
    const auto count = [&](double travel) { return std::floor((travel + 0.01 * normal()) / mouse_.count); };
    fmt::format_to(std::back_inserter(text_), "{},{:.5f},{:.5f},{},{},{:.6f},{},{}\n", time_++, left, right,
                   count(travel_[0]), count(travel_[1]), turning_ + mouse_.gyro_noise * normal(),
                   wall_ > 0.0 ? fmt::format("{}", reading()) : "0", wall_ > 0.0 ? fmt::format("{:.1f}", wall_) : "");
  }

  SimulatedMouse mouse_;
  Dice dice_;
  std::string text_ = "t,l,r,cl,cr,g,ir,wall\n";
  int time_ = 0;
  double onwards_ = 0.0, around_ = 0.0, speed_ = 0.0, turning_ = 0.0, wall_ = 0.0, true_wall_ = 0.0;
  double reflectance_ = 1.0;
  std::array<double, 2> travel_{};
};

}  // namespace labmouse::test
