// A mouse of round numbers without any noise, and a world for it.
#pragma once

#include "labmouse/body/body.hpp"
#include "labmouse/maze/generators/generator.hpp"

namespace labmouse::test {

inline constexpr double cell = 100.0;  ///< mm; walls are 6.67 mm thick

inline Hardware plain_mouse() {
  Hardware hardware;
  hardware.chassis = {25.0, 15.0, 18.0, 16.0};
  hardware.motors = {.drive = {3000.0, 0.1, 0.05}, .turn = {80.0, 0.08, 0.04}, .volts = 4.0};
  hardware.tyres = {.stiffness = 100000.0, .grip = 10000.0};
  hardware.sensors.count = 0.001;
  hardware.sensors.gyro_step = 0.001;
  hardware.sensors.gyro_most = 30.0;
  hardware.sensors.acceleration_step = 5.0;
  for (const Beam& beam :
       {Beam{12.0, -12.0, -1.15}, Beam{20.0, -8.0, -0.1}, Beam{12.0, 12.0, 1.15}, Beam{20.0, 8.0, 0.1}})
    hardware.sensors.infrared.push_back({beam, 700.0, 13.0, 3600.0, 5.0});
  hardware.sensors.rangers = {{{20.0, 0.0, 0.0}, 250.0, 10.0}};
  return hardware;
}

/// Round noise of all kinds.
inline Noise plain_noise() {
  Noise noise;
  noise.gyro_bias = 0.01;
  noise.ripple = 0.1;
  noise.ripple_length = 12.5;
  noise.encoder = 0.02;
  noise.gyro = 0.01;
  noise.gyro_walk = 0.003;
  noise.acceleration = 400.0;
  noise.infrared = 3.0;
  noise.infrared_share = 0.01;
  noise.infrared_memory = 0.4;
  noise.ranger_rest = 1.5;
  noise.ranger = 3.0;
  noise.shaking = 0.25;
  noise.shaking_speed = 300.0;
  noise.shaking_pitch = 200.0;
  noise.shaking_loss = 0.25;
  return noise;
}

/// Round variation of all kinds.
inline Variation plain_variation() {
  return {.motor_gain = 0.05,
          .battery = 0.05,
          .stiffness = 0.2,
          .grip = 0.1,
          .encoder_scale = 0.01,
          .gyro_scale = 0.005,
          .acceleration_bias = 300.0,
          .infrared_gain = 0.05,
          .reflectance = 0.05,
          .maze_reflectance = 0.1,
          .post_shift = 1.0,
          .ambient = 30.0,
          .ambient_drift = 10.0,
          .dust = 0.1,
          .floor_steps = 0.2,
          .floor_turn = 0.01,
          .floor_shift = 0.5,
          .floor_tilt = 0.01,
          .placement = 1.0,
          .placement_turn = 0.02};
}

/// The plain mouse with all noise and all variation.
inline Hardware varied_mouse() {
  Hardware hardware = plain_mouse();
  hardware.noise = plain_noise();
  hardware.variation = plain_variation();
  return hardware;
}

/// The scale with just one cause of errors.
inline ErrorScale only(ErrorCause cause) {
  ErrorScale scale;
  scale.causes.fill(0.0);
  scale.causes[static_cast<std::size_t>(cause)] = 1.0;
  return scale;
}
/// The scale without a cause.
inline ErrorScale all_but(ErrorCause cause) {
  ErrorScale scale;
  scale.causes[static_cast<std::size_t>(cause)] = 0.0;
  return scale;
}

/// Nothing but the border: room to drive.
inline Maze hall(int side) { return Maze(MazeDraft({side, side}, MazeDraft::Inside::open)); }

/// A maze with walls everywhere.
inline Maze some_maze(std::uint64_t seed) { return depth_first_generator.make({{8, 8}, seed, 30}); }

}  // namespace labmouse::test
