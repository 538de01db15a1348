// The hardware of a robot: its shape, motors and sensors, their noise, and how far mice and mazes vary.
//
//              front
//        +---------------+      x ahead of the middle of the axle, y to the left of it, in mm;
//        |               |      angles in rad to the left of ahead
//        |               |
//  wheel |------ + ------| wheel
//        |               |
//        +---------------+
//              back
//
// A duty (PWM duty cycle) is a share of what the battery can give, from -1 to 1.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace labmouse {

/// The rectangle that touches walls, measured from the middle of the axle, in mm. Its corners can be round.
struct Chassis {
  double front = 0.0;       ///< distance to its foremost point
  double back = 0.0;        ///< distance to its hindmost point
  double half_width = 0.0;  ///< distance to its side
  double half_track = 0.0;  ///< half the distance between the wheels: travel of a wheel for each rad of turning
  double rounding = 0.0;    ///< radius of its corners; a round chassis has that of a circle

  friend bool operator==(const Chassis&, const Chassis&) = default;
};

/// First-order model of forward motion (mm/s) or turning (rad/s). At a constant duty the speed approaches `gain` times
/// the duty beyond the dead zone, with the time constant `time`.
struct MotorAxis {
  double gain = 0.0;       ///< mm/s or rad/s for a duty of 1
  double time = 0.0;       ///< s
  double dead_zone = 0.0;  ///< duty that friction takes

  friend bool operator==(const MotorAxis&, const MotorAxis&) = default;
};

/// The motors and the battery.
struct Motors {
  MotorAxis drive;         ///< of the mean duty of both wheels
  MotorAxis turn;          ///< of the right wheel's duty less the left one's
  double turning = 0.0;    ///< forward duty that turning takes, per rad/s
  double rotating = 0.0;   ///< share of the inertia that turns with the wheels; 0: wheels never spin
  double sag = 0.0;        ///< share of the voltage that is lost at full duty of both
  double discharge = 0.0;  ///< share of the voltage that is lost for good in a second at full duty of both
  double volts = 0.0;      ///< V, of the full battery at rest
  double period = 1.0;     ///< ms, whole, from one duty of the controller to the next
  std::array<double, 2> strength = {1.0, 1.0};  ///< of the left and the right motor, as a share of their gains
  double dead_time = 0.0;                       ///< duty that the driver loses while it switches
  double coast = 0.0;                           ///< 1: motors coast while the driver is off; 0: they brake

  friend bool operator==(const Motors&, const Motors&) = default;
};

/// The tyres: how they slip, and what they hold.
struct Tyres {
  double stiffness = 0.0;  ///< mm/s² of lateral acceleration per rad of slip angle
  double grip = 0.0;       ///< mm/s², the most in any direction
  double downforce = 0.0;  ///< mm/s² of grip that the fan adds; it runs in speed runs
  /// rad/s² of turning for each mm/s² of lateral acceleration: the yaw moment of the tyres, which act behind the centre
  /// of mass. That is its distance ahead of the axle, divided by the square of the radius of gyration, in 1/mm.
  double yaw_moment = 0.0;

  friend bool operator==(const Tyres&, const Tyres&) = default;
};

/// Where a sensor is mounted, in mm ahead and to the left, and the angle at which it looks, in rad to the left.
struct Beam {
  double ahead = 0.0;  ///< mm before the axle
  double aside = 0.0;  ///< mm to the left of the middle
  double angle = 0.0;  ///< rad to the left of ahead

  friend bool operator==(const Beam&, const Beam&) = default;
};

/// The most infrared sensors and the most ToF sensors of a robot.
inline constexpr std::size_t most_infrared = 16, most_rangers = 8;

/// An infrared sensor. At a right angle to a wall it reads gain * exp(-(distance - calibrated) / fall), or
/// gain * (calibrated / distance)² where `fall` is below 1; up to `most`. `calibrated` is the length of its beam in mm
/// while the mouse stands in the middle of a cell: to the side wall, or to the front wall if it looks ahead.
struct Infrared {
  Beam beam;
  double gain = 0.0;       ///< counts, of a wall at the calibrated distance
  double fall = 0.0;       ///< mm
  double most = 0.0;       ///< counts; of an ADC with n bits: 2^n - 1
  double footprint = 0.0;  ///< mm, standard deviation of the light spot on a wall at a right angle
  double group = 0.0;      ///< from 0, whole: sensors of a group are lit and read at the same tick, the groups in turn
  double latency = 0.0;    ///< ms between the light and the reading, whole

  friend bool operator==(const Infrared&, const Infrared&) = default;
};

/// A ToF distance sensor.
struct Ranger {
  Beam beam;
  double reach = 0.0;    ///< mm; nothing is seen beyond
  double period = 11.0;  ///< ms between two readings, whole

  friend bool operator==(const Ranger&, const Ranger&) = default;
};

/// The sensors of a robot. A step of 0 means that it has no such sensor.
struct Sensors {
  double count = 0.0;              ///< mm of travel of a wheel per count of its encoder
  double count_bits = 32.0;        ///< of the counters, which wrap
  double gyro_step = 0.0;          ///< rad/s per unit
  double gyro_most = 0.0;          ///< rad/s, the measuring range
  double acceleration_step = 0;    ///< mm/s² per unit
  std::vector<Infrared> infrared;  ///< at most `most_infrared`
  std::vector<Ranger> rangers;     ///< at most `most_rangers`

  /// Whether the robot has a gyroscope.
  bool has_gyro() const { return gyro_step > 0.0; }
  /// Whether the robot has an accelerometer.
  bool has_accelerometer() const { return acceleration_step > 0.0; }

  friend bool operator==(const Sensors&, const Sensors&) = default;
};

/// Random errors at each moment: standard deviations, unless stated otherwise.
struct Noise {
  double gyro_bias = 0.0;        ///< rad/s, after each calibration at rest
  double ripple = 0.0;           ///< mm, amplitude of an encoder's error over a turn of its magnet
  double ripple_length = 1.0;    ///< mm of travel in such a turn
  double encoder = 0.0;          ///< mm
  double gyro = 0.0;             ///< rad/s
  double gyro_walk = 0.0;        ///< rad/s per square root of a second
  double acceleration = 0.0;     ///< mm/s²
  double infrared = 0.0;         ///< counts
  double infrared_share = 0.0;   ///< counts per count of the level, added to `infrared`
  double infrared_memory = 0.0;  ///< correlation of an error with that of the tick before, 0 to 1
  double ranger_rest = 0.0;      ///< mm, at rest
  double ranger = 0.0;           ///< mm, while moving
  double shaking = 0.0;          ///< rad/s of yaw at shaking_speed and above; below, in proportion to the speed
  double shaking_speed = 1.0;    ///< mm/s
  double shaking_pitch = 0.0;    ///< rad/s, angular frequency of its resonance
  double shaking_loss = 0.0;     ///< damping ratio of the resonance

  friend bool operator==(const Noise&, const Noise&) = default;
};

/// How mice, mazes and days differ from the nominal numbers: standard deviations of what is drawn once a contest,
/// unless stated otherwise. Shares are deviations of a logarithm.
struct Variation {
  // Of the mouse.
  double motor_gain = 0.0;         ///< share, of each motor, at most a fifth off
  double battery = 0.0;            ///< share of the voltage that it lacks at the start, not of a logarithm
  double stiffness = 0.0;          ///< share
  double grip = 0.0;               ///< share
  double encoder_scale = 0.0;      ///< share, of each wheel: its diameter
  double gyro_scale = 0.0;         ///< share
  double acceleration_bias = 0.0;  ///< mm/s², of each axis: offset, and a sensor that is mounted at an angle
  double infrared_gain = 0.0;      ///< share, of each sensor
  // Of the maze and the day.
  double reflectance = 0.0;       ///< share, of each side of each wall
  double maze_reflectance = 0.0;  ///< share, of all walls
  double post_shift = 0.0;        ///< mm, of each post, in x and in y, at most 4/3 of it; walls stand between posts
  double ambient = 0.0;           ///< counts that the ambient light adds to an infrared sensor, of each sensor
  double ambient_drift = 0.0;     ///< counts per square root of a second by which that changes
  double dust = 0.0;              ///< share of the grip, of each cell
  double floor_steps = 0.0;       ///< share of the boundaries between cells that have a step of the floor
  double floor_turn = 0.0;        ///< rad by which such a step turns the mouse
  double floor_shift = 0.0;       ///< mm by which it moves it aside
  double floor_tilt = 0.0;        ///< rad, of the floor of each cell, along x and along y
  // Each time that it is put down.
  double placement = 0.0;       ///< mm, in x and in y
  double placement_turn = 0.0;  ///< rad

  friend bool operator==(const Variation&, const Variation&) = default;
};

/// The whole hardware. The size of the cells is in Robot.
struct Hardware {
  Chassis chassis;
  Motors motors;
  Tyres tyres;
  Sensors sensors;
  Noise noise;
  Variation variation;

  friend bool operator==(const Hardware&, const Hardware&) = default;
};

/// The causes of errors, which can be switched one by one. Each has parts in Noise, in Variation, or in both.
enum class ErrorCause : std::size_t {
  motors,  ///< and the battery
  tyres,   ///< and dust
  floor,
  posts,
  encoders,
  gyro,
  accelerometer,
  infrared,
  reflectance,
  ambient,
  ranger,
  shaking,
  placement
};
/// The number of causes.
inline constexpr std::size_t error_causes = 13;

/// The name of a cause, for users: "ToF sensor".
/// @param cause one of the causes.
/// @return in static memory.
constexpr std::string_view name_of(ErrorCause cause) {
  constexpr std::array<std::string_view, error_causes> names = {
      "motors",   "tyres",       "floor",         "posts",      "encoders", "gyro",     "accelerometer",
      "infrared", "reflectance", "ambient light", "ToF sensor", "shaking",  "placement"};
  return names[static_cast<std::size_t>(cause)];
}

}  // namespace labmouse
