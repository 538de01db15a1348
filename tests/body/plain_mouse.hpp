// A mouse of round numbers without any noise, and a world for it.
#pragma once

#include "labmouse/body/body.hpp"
#include "labmouse/maze/generators/generator.hpp"

namespace labmouse::test {

inline constexpr double cell = 100.0;  ///< mm; walls are 6.67 mm thick

inline Hardware plain_mouse() {
  Hardware hardware;
  hardware.chassis = {25.0, 15.0, 18.0, 16.0};
  hardware.motors = {{3000.0, 0.1, 0.05}, {80.0, 0.08, 0.04}, 0.0, 0.0, 4.0};
  hardware.tyres = {100000.0, 10000.0};
  hardware.sensors.count = 0.001;
  hardware.sensors.gyro_step = 0.001;
  hardware.sensors.gyro_most = 30.0;
  hardware.sensors.acceleration_step = 5.0;
  hardware.sensors.infrared = {
      {Beam{12.0, -12.0, -1.15}, Beam{20.0, -8.0, -0.1}, Beam{12.0, 12.0, 1.15}, Beam{20.0, 8.0, 0.1}},
      700.0,
      13.0,
      3600.0,
      5.0};
  hardware.sensors.ranger = {20.0, 250.0, 10.0};
  return hardware;
}

/// Round noise of all kinds.
inline Noise plain_noise() {
  Noise noise;
  noise.motor_gain = 0.1;
  noise.stiffness = 0.2;
  noise.grip = 0.1;
  noise.encoder_scale = 0.01;
  noise.gyro_scale = 0.005;
  noise.gyro_bias = 0.01;
  noise.infrared_gain = 0.05;
  noise.reflectance = 0.05;
  noise.floor_steps = 0.2;
  noise.floor_turn = 0.01;
  noise.floor_shift = 0.5;
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
  noise.placement = 1.0;
  noise.placement_turn = 0.02;
  return noise;
}

/// The level with just one group of noise.
inline NoiseLevel only(NoiseGroup group) {
  NoiseLevel level;
  level.groups.fill(0.0);
  level.groups[static_cast<std::size_t>(group)] = 1.0;
  return level;
}
/// The level without a group.
inline NoiseLevel all_but(NoiseGroup group) {
  NoiseLevel level;
  level.groups[static_cast<std::size_t>(group)] = 0.0;
  return level;
}

/// Nothing but the border: room to drive.
inline Maze hall(int side) { return Maze(MazeDraft({side, side}, MazeDraft::Inside::open)); }

/// A maze with walls everywhere.
inline Maze some_maze(std::uint64_t seed) { return depth_first_generator.make({{8, 8}, seed, 30}); }

}  // namespace labmouse::test
