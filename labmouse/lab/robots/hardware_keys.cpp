#include "labmouse/lab/robots/hardware_keys.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "labmouse/hardware/beam.hpp"

namespace labmouse {
namespace {

using Sensor = RobotKey::Sensor;

/// The sensor to which a key belongs.
constexpr Sensor sensor_of(std::string_view name) {
  const auto in = [&](std::string_view part) { return name.find(part) != std::string_view::npos; };
  if (name.starts_with("body.") || name.starts_with("motors.")) return Sensor::none;
  if (in(".gyro")) return Sensor::gyro;
  if (in(".acceleration")) return Sensor::accelerometer;
  if (in(".side_")) return Sensor::side;
  if (in(".front_")) return Sensor::front;
  if (in(".infrared")) return Sensor::infrared;
  return in(".ranger") ? Sensor::ranger : Sensor::none;
}

constexpr HardwareKey of(std::string_view name, std::string_view meaning, std::string_view unit, double low,
                         double high, double& (*number)(HardwareNumbers&), double factor = 1.0) {
  RobotKey key{name, meaning, unit, low, high, RobotKey::With::body};
  if (name == "sensors.ranger_period" || name == "sensors.count_bits" || name == "motors.period" ||
      name == "motors.coast")
    key.kind = RobotKey::Kind::whole;
  key.sensor = sensor_of(name);
  return {key, number, factor};
}

/// A key that files may leave out; then its number is that of a Hardware without numbers.
constexpr HardwareKey may_lack(HardwareKey key) {
  key.key.needed = false;
  return key;
}

/// The same of a key that earlier records lack.
constexpr HardwareKey added_later(HardwareKey key) {
  key.added_later = true;
  return may_lack(key);
}

/// A standard deviation of what is drawn once a contest. Those that stood among the noise in earlier versions have a
/// former name, and are needed.
constexpr HardwareKey varies(std::string_view name, std::string_view meaning, std::string_view unit, double high,
                             double& (*number)(HardwareNumbers&), std::string_view former = {}) {
  HardwareKey key = of(name, meaning, unit, 0.0, high, number);
  key.key.former = former;
  key.key.needed = !former.empty();
  return key;
}

constexpr std::array keys = {
    of("body.front", "from the middle of the axle to its foremost point", "mm", 1.0, 500.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.chassis.front; }),
    of("body.back", "from the middle of the axle to its hindmost point", "mm", 1.0, 500.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.chassis.back; }),
    of("body.half_width", "from its middle to its side", "mm", 1.0, 500.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.chassis.half_width; }),
    of("body.half_track",
       "from its middle to where a wheel rolls; with four wheels, which slide in turns, travel of a wheel for each rad "
       "of turning",
       "mm", 1.0, 500.0, [](HardwareNumbers& n) -> double& { return n.hardware.chassis.half_track; }),
    added_later(of("body.rounding",
                   "radius of the corners of its chassis; of a round chassis that of the circle; default 0", "mm", 0.0,
                   500.0, [](HardwareNumbers& n) -> double& { return n.hardware.chassis.rounding; })),
    of("body.slip_stiffness", "lateral acceleration for a rad of slip", "mm/s²", 1000.0, 100000000.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.tyres.stiffness; }),
    of("body.grip", "what the tyres hold in any direction", "mm/s²", 100.0, 200000.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.tyres.grip; }),
    may_lack(of("body.downforce", "grip that the fan adds, which runs in speed runs; default 0: none", "mm/s²", 0.0,
                200000.0, [](HardwareNumbers& n) -> double& { return n.hardware.tyres.downforce; })),
    may_lack(of("body.yaw_moment",
                "how the tyres turn it back: distance of the centre of mass ahead of the axle, divided by the square "
                "of the radius of gyration; default 0",
                "1/mm", 0.0, 1.0, [](HardwareNumbers& n) -> double& { return n.hardware.tyres.yaw_moment; })),
    of("motors.drive_gain", "the speed that full duty leads to", "mm/s", 10.0, 100000.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.motors.drive.gain; }),
    of(
        "motors.drive_time", "the time constant of that", "ms", 1.0, 10000.0,
        [](HardwareNumbers& n) -> double& { return n.hardware.motors.drive.time; }, 1000),
    of("motors.drive_dead_zone", "share of full duty that friction takes", "", 0.0, 0.9,
       [](HardwareNumbers& n) -> double& { return n.hardware.motors.drive.dead_zone; }),
    of("motors.turn_gain", "the yaw speed at a difference of 1: the right motor's duty less the left one's", "rad/s",
       1.0, 10000.0, [](HardwareNumbers& n) -> double& { return n.hardware.motors.turn.gain; }),
    of(
        "motors.turn_time", "the time constant of that", "ms", 1.0, 10000.0,
        [](HardwareNumbers& n) -> double& { return n.hardware.motors.turn.time; }, 1000),
    of("motors.turn_dead_zone", "share of full duty that friction takes", "", 0.0, 0.9,
       [](HardwareNumbers& n) -> double& { return n.hardware.motors.turn.dead_zone; }),
    of("motors.turning", "share of full duty that a turn of a rad/s takes from driving on", "", 0.0, 0.1,
       [](HardwareNumbers& n) -> double& { return n.hardware.motors.turning; }),
    may_lack(of("motors.rotating", "share of the inertia that turns with the wheels; default 0: they never spin", "",
                0.0, 0.9, [](HardwareNumbers& n) -> double& { return n.hardware.motors.rotating; })),
    of("motors.sag", "share of the voltage that is lost at full duty", "", 0.0, 0.9,
       [](HardwareNumbers& n) -> double& { return n.hardware.motors.sag; }),
    may_lack(of("motors.discharge", "share of the voltage that is lost for good in a second at full duty; default 0",
                "", 0.0, 0.1, [](HardwareNumbers& n) -> double& { return n.hardware.motors.discharge; })),
    of("motors.volts", "of the full battery at rest", "V", 0.5, 60.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.motors.volts; }),
    added_later(of("motors.period",
                   "from one duty of the built-in controller to the next: 2 is a loop of 500 Hz; default 1", "ms", 1.0,
                   10.0, [](HardwareNumbers& n) -> double& { return n.hardware.motors.period; })),
    added_later(of("motors.left", "strength of the left motor, as a share of the nominal one; default 1", "", 0.5, 2.0,
                   [](HardwareNumbers& n) -> double& { return n.hardware.motors.strength[0]; })),
    added_later(of("motors.right", "strength of the right motor; default 1", "", 0.5, 2.0,
                   [](HardwareNumbers& n) -> double& { return n.hardware.motors.strength[1]; })),
    added_later(of("motors.dead_time",
                   "share of full duty that the driver loses while it switches; smaller duties do nothing; default 0",
                   "", 0.0, 0.5, [](HardwareNumbers& n) -> double& { return n.hardware.motors.dead_time; })),
    added_later(of("motors.coast", "1: the motors coast while the driver is off; default 0: they brake", "", 0.0, 1.0,
                   [](HardwareNumbers& n) -> double& { return n.hardware.motors.coast; })),
    of("sensors.count", "travel of a wheel for a count of its encoder", "mm", 1e-06, 10.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.sensors.count; }),
    added_later(of("sensors.count_bits", "width of the counters of the encoders, which wrap; default 32", "bits", 8.0,
                   32.0, [](HardwareNumbers& n) -> double& { return n.hardware.sensors.count_bits; })),
    of("sensors.gyro_step", "yaw speed for a unit of the gyro", "rad/s", 1e-06, 1.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.sensors.gyro_step; }),
    of("sensors.gyro_most", "the largest yaw speed that it shows", "rad/s", 1.0, 1000.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.sensors.gyro_most; }),
    of("sensors.acceleration_step", "acceleration for a unit of the accelerometer", "mm/s²", 0.001, 1000.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.sensors.acceleration_step; }),
    of("sensors.side_ahead", "how far before the axle the side sensors sit", "mm", -500.0, 500.0,
       [](HardwareNumbers& n) -> double& { return n.side.ahead; }),
    of("sensors.side_aside", "how far from the middle", "mm", 0.0, 500.0,
       [](HardwareNumbers& n) -> double& { return n.side.aside; }),
    // At less than 45 degrees a sensor looks ahead rather than aside: side_of().
    of("sensors.side_angle", "how far from straight ahead they look", "rad", 0.785, 1.6,
       [](HardwareNumbers& n) -> double& { return n.side.angle; }),
    of("sensors.front_ahead", "how far before the axle the front sensors sit", "mm", -500.0, 500.0,
       [](HardwareNumbers& n) -> double& { return n.front.ahead; }),
    of("sensors.front_aside", "how far from the middle", "mm", 0.0, 500.0,
       [](HardwareNumbers& n) -> double& { return n.front.aside; }),
    of("sensors.front_angle", "how far from straight ahead they look", "rad", 0.0, 0.784,
       [](HardwareNumbers& n) -> double& { return n.front.angle; }),
    of("sensors.infrared_gain", "what a sensor reads of a wall in the middle of a cell", "counts", 10.0, 30000.0,
       [](HardwareNumbers& n) -> double& { return n.infrared.gain; }),
    of("sensors.infrared_fall",
       "how much farther a wall is that is read as 1/e of that; 0: readings fall with the square of the distance", "mm",
       0.0, 500.0, [](HardwareNumbers& n) -> double& { return n.infrared.fall; }),
    of("sensors.infrared_most", "the largest reading", "counts", 10.0, 32767.0,
       [](HardwareNumbers& n) -> double& { return n.infrared.most; }),
    of("sensors.infrared_footprint", "standard deviation of a sensor's spot on a wall", "mm", 0.1, 100.0,
       [](HardwareNumbers& n) -> double& { return n.infrared.footprint; }),
    of("sensors.ranger_ahead", "how far before the axle the distance sensor sits", "mm", -500.0, 500.0,
       [](HardwareNumbers& n) -> double& { return n.ranger.beam.ahead; }),
    of("sensors.ranger_reach", "the largest distance that it sees", "mm", 1.0, 10000.0,
       [](HardwareNumbers& n) -> double& { return n.ranger.reach; }),
    of("sensors.ranger_period", "from one of its readings to the next", "ms", 1.0, 1000.0,
       [](HardwareNumbers& n) -> double& { return n.ranger.period; }),
    of("noise.gyro_bias", "after each calibration at rest", "rad/s", 0.0, 10.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.noise.gyro_bias; }),
    of("noise.ripple", "amplitude of an encoder's error over a turn of its magnet", "mm", 0.0, 10.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.noise.ripple; }),
    of("noise.ripple_length", "travel in such a turn", "mm", 0.1, 1000.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.noise.ripple_length; }),
    of("noise.encoder", "of each moment, as are those that follow", "mm", 0.0, 10.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.noise.encoder; }),
    of("noise.gyro", "the same of the gyro", "rad/s", 0.0, 10.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.noise.gyro; }),
    of("noise.gyro_walk", "how its bias wanders", "rad/s/√s", 0.0, 10.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.noise.gyro_walk; }),
    of("noise.acceleration", "the same of the accelerometer", "mm/s²", 0.0, 100000.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.noise.acceleration; }),
    of("noise.infrared", "the same of an infrared sensor", "counts", 0.0, 10000.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.noise.infrared; }),
    of("noise.infrared_share", "added for each count of the level", "share", 0.0, 1.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.noise.infrared_share; }),
    of("noise.infrared_memory", "how much of one moment's error is left in the next", "share", 0.0, 0.99,
       [](HardwareNumbers& n) -> double& { return n.hardware.noise.infrared_memory; }),
    of("noise.ranger_rest", "of a mouse at rest", "mm", 0.0, 1000.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.noise.ranger_rest; }),
    of("noise.ranger", "of one that moves", "mm", 0.0, 1000.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.noise.ranger; }),
    of("noise.shaking", "yaw speed of what shakes it", "rad/s", 0.0, 100.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.noise.shaking; }),
    of("noise.shaking_speed", "from this speed on; below it shakes in proportion", "mm/s", 1.0, 100000.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.noise.shaking_speed; }),
    of(
        "noise.shaking_pitch", "frequency of its resonance", "Hz", 0.1, 400.0,
        [](HardwareNumbers& n) -> double& { return n.hardware.noise.shaking_pitch; }, 0.15915494309189535),
    of("noise.shaking_loss", "how damped that is, as a share of critical", "share", 0.01, 2.0,
       [](HardwareNumbers& n) -> double& { return n.hardware.noise.shaking_loss; }),
    varies(
        "variation.motor_gain", "of each motor, at most a fifth off", "share", 1.0,
        [](HardwareNumbers& n) -> double& { return n.hardware.variation.motor_gain; }, "noise.motor_gain"),
    varies("variation.battery", "of the voltage that the battery lacks at the start", "share", 1.0,
           [](HardwareNumbers& n) -> double& { return n.hardware.variation.battery; }),
    varies(
        "variation.slip_stiffness", "of body.slip_stiffness", "share", 1.0,
        [](HardwareNumbers& n) -> double& { return n.hardware.variation.stiffness; }, "noise.slip_stiffness"),
    varies(
        "variation.grip", "of body.grip", "share", 1.0,
        [](HardwareNumbers& n) -> double& { return n.hardware.variation.grip; }, "noise.grip"),
    varies("variation.dust", "of the grip that the dust of a cell takes", "share", 1.0,
           [](HardwareNumbers& n) -> double& { return n.hardware.variation.dust; }),
    varies(
        "variation.encoder_scale", "of each wheel", "share", 1.0,
        [](HardwareNumbers& n) -> double& { return n.hardware.variation.encoder_scale; }, "noise.encoder_scale"),
    varies(
        "variation.gyro_scale", "of what the gyro shows", "share", 1.0,
        [](HardwareNumbers& n) -> double& { return n.hardware.variation.gyro_scale; }, "noise.gyro_scale"),
    varies("variation.acceleration_bias", "offset of each axis of the accelerometer", "mm/s²", 10000.0,
           [](HardwareNumbers& n) -> double& { return n.hardware.variation.acceleration_bias; }),
    varies(
        "variation.infrared_gain", "of each infrared sensor, after its calibration", "share", 1.0,
        [](HardwareNumbers& n) -> double& { return n.hardware.variation.infrared_gain; }, "noise.infrared_gain"),
    varies(
        "variation.reflectance", "of each side of each wall", "share", 1.0,
        [](HardwareNumbers& n) -> double& { return n.hardware.variation.reflectance; }, "noise.reflectance"),
    varies("variation.maze_reflectance", "of all walls of a maze", "share", 1.0,
           [](HardwareNumbers& n) -> double& { return n.hardware.variation.maze_reflectance; }),
    varies("variation.post_shift", "of each post, in x and in y; walls stand between their posts", "mm", 20.0,
           [](HardwareNumbers& n) -> double& { return n.hardware.variation.post_shift; }),
    varies("variation.ambient", "what the light of the room adds to an infrared sensor", "counts", 10000.0,
           [](HardwareNumbers& n) -> double& { return n.hardware.variation.ambient; }),
    varies("variation.ambient_drift", "how that changes", "counts/√s", 10000.0,
           [](HardwareNumbers& n) -> double& { return n.hardware.variation.ambient_drift; }),
    varies(
        "variation.floor_steps", "how many boundaries between cells have a step of the floor", "share", 1.0,
        [](HardwareNumbers& n) -> double& { return n.hardware.variation.floor_steps; }, "noise.floor_steps"),
    varies(
        "variation.floor_turn", "by how much such a step turns the mouse", "rad", 1.0,
        [](HardwareNumbers& n) -> double& { return n.hardware.variation.floor_turn; }, "noise.floor_turn"),
    varies(
        "variation.floor_shift", "by how much it moves the mouse aside", "mm", 100.0,
        [](HardwareNumbers& n) -> double& { return n.hardware.variation.floor_shift; }, "noise.floor_shift"),
    varies("variation.floor_tilt", "of the floor of each cell, along x and along y", "rad", 0.2,
           [](HardwareNumbers& n) -> double& { return n.hardware.variation.floor_tilt; }),
    varies(
        "variation.placement", "of a hand that puts the mouse down, each way", "mm", 100.0,
        [](HardwareNumbers& n) -> double& { return n.hardware.variation.placement; }, "noise.placement"),
    varies(
        "variation.placement_turn", "of the same", "rad", 1.0,
        [](HardwareNumbers& n) -> double& { return n.hardware.variation.placement_turn; }, "noise.placement_turn"),
};

template <class Which>
constexpr SensorKey<Which> in_list(RobotKey key, double& (*number)(Which&)) {
  key.with = RobotKey::With::body;
  return {key, number};
}

constexpr auto whole = RobotKey::Kind::whole;
// How a sensor is mounted.
template <class Which>
constexpr auto ahead_key = in_list<Which>({"ahead", "how far before the axle it sits", "mm", -500.0, 500.0},
                                          [](Which& one) -> double& { return one.beam.ahead; });
template <class Which>
constexpr auto aside_key = in_list<Which>({"aside", "how far to the left of the middle; to the right below 0", "mm",
                                           -500.0, 500.0},
                                          [](Which& one) -> double& { return one.beam.aside; });
template <class Which>
constexpr auto angle_key = in_list<Which>({"angle", "the direction in which it looks, to the left of ahead", "rad",
                                           -1.6, 1.6},
                                          [](Which& one) -> double& { return one.beam.angle; });

constexpr std::array infrared_table = {
    ahead_key<Infrared>,
    aside_key<Infrared>,
    angle_key<Infrared>,
    in_list<Infrared>({.name = "gain",
                       .meaning = "what it reads of a wall in the middle of a cell; default: sensors.infrared_gain",
                       .unit = "counts",
                       .low = 10.0,
                       .high = 30000.0,
                       .needed = false},
                      [](Infrared& one) -> double& { return one.gain; }),
    in_list<Infrared>({.name = "fall",
                       .meaning = "as sensors.infrared_fall, which is the default",
                       .unit = "mm",
                       .low = 0.0,
                       .high = 500.0,
                       .needed = false},
                      [](Infrared& one) -> double& { return one.fall; }),
    in_list<Infrared>({.name = "most",
                       .meaning = "the largest reading; default: sensors.infrared_most",
                       .unit = "counts",
                       .low = 10.0,
                       .high = 32767.0,
                       .needed = false},
                      [](Infrared& one) -> double& { return one.most; }),
    in_list<Infrared>({.name = "footprint",
                       .meaning = "standard deviation of its spot on a wall; default: sensors.infrared_footprint",
                       .unit = "mm",
                       .low = 0.1,
                       .high = 100.0,
                       .needed = false},
                      [](Infrared& one) -> double& { return one.footprint; }),
    in_list<Infrared>(
        {.name = "group",
         .meaning = "sensors with the same number are lit together, and the groups one each ms; default 0",
         .unit = "",
         .low = 0.0,
         .high = 15.0,
         .needed = false,
         .kind = whole},
        [](Infrared& one) -> double& { return one.group; }),
    in_list<Infrared>({.name = "latency",
                       .meaning = "from the light to the reading; default 0",
                       .unit = "ms",
                       .low = 0.0,
                       .high = 100.0,
                       .needed = false,
                       .kind = whole},
                      [](Infrared& one) -> double& { return one.latency; }),
};

constexpr std::array ranger_table = {
    ahead_key<Ranger>,
    aside_key<Ranger>,
    angle_key<Ranger>,
    in_list<Ranger>(
        {.name = "reach", .meaning = "the largest distance that it sees", .unit = "mm", .low = 1.0, .high = 10000.0},
        [](Ranger& one) -> double& { return one.reach; }),
    in_list<Ranger>({.name = "period",
                     .meaning = "from one of its readings to the next",
                     .unit = "ms",
                     .low = 1.0,
                     .high = 1000.0,
                     .kind = whole},
                    [](Ranger& one) -> double& { return one.period; }),
};

Infrared with_beam(Infrared sensor, const Beam& beam) {
  sensor.beam = beam;
  return sensor;
}
Beam mirrored(const Beam& beam) { return {beam.ahead, -beam.aside, -beam.angle}; }

}  // namespace

std::span<const HardwareKey> hardware_keys() { return keys; }
std::span<const SensorKey<Infrared>> infrared_keys() { return infrared_table; }
std::span<const SensorKey<Ranger>> ranger_keys() { return ranger_table; }

Hardware hardware_of(const HardwareNumbers& numbers, PlainSensors which) {
  Hardware hardware = numbers.hardware;
  auto& infrared = hardware.sensors.infrared;
  // The right ones come first.
  const auto add = [&](const Beam& beam) { infrared.push_back(with_beam(numbers.infrared, beam)); };
  if (which.side) add(mirrored(numbers.side));
  if (which.front) add(mirrored(numbers.front));
  if (which.side) add(numbers.side);
  if (which.front) add(numbers.front);
  if (which.ranger) hardware.sensors.rangers.push_back(numbers.ranger);
  return hardware;
}

namespace {

/// Whether it is an infrared or a ToF sensor.
bool is_of_walls(Sensor sensor) {
  return sensor == Sensor::side || sensor == Sensor::front || sensor == Sensor::infrared || sensor == Sensor::ranger;
}

}  // namespace

HardwareTerms terms_of(const Hardware& hardware) {
  HardwareTerms terms;
  auto& [numbers, plain, lists] = terms;
  numbers.hardware = hardware;
  numbers.hardware.sensors.infrared.clear();
  numbers.hardware.sensors.rangers.clear();
  const Sensors& sensors = hardware.sensors;
  for (const Infrared& sensor : sensors.infrared) {
    const bool ahead = side_of(sensor.beam) == BeamSide::ahead;
    numbers.infrared = with_beam(sensor, {});
    // The left ones come last.
    (ahead ? numbers.front : numbers.side) = sensor.beam;
    (ahead ? plain.front : plain.side) = true;
  }
  // No key of a pair has these.
  numbers.infrared.group = numbers.infrared.latency = 0.0;
  plain.ranger = !sensors.rangers.empty();
  if (plain.ranger) numbers.ranger = sensors.rangers.front();
  numbers.ranger.beam.aside = numbers.ranger.beam.angle = 0.0;
  const auto out_of_range = [&terms](const HardwareKey& key) {
    const double number = key.number(terms.numbers) * key.unit;
    return is_of_walls(key.key.sensor) && terms.has(key.key) && (number < key.key.low || number > key.key.high);
  };
  lists = hardware_of(numbers, plain) != hardware || std::any_of(keys.begin(), keys.end(), out_of_range);
  if (lists) terms = {{.hardware = hardware, .side = {}, .front = {}, .infrared = {}, .ranger = {}}, {}, true};
  return terms;
}

bool HardwareTerms::has(const RobotKey& key) const {
  // Sensors of a list have their own numbers there, and their noise in common.
  const Sensors& listed = numbers.hardware.sensors;
  const bool in_common = lists && !key.name.starts_with("sensors.");
  switch (key.sensor) {
    case Sensor::gyro:
      return numbers.hardware.sensors.has_gyro();
    case Sensor::accelerometer:
      return numbers.hardware.sensors.has_accelerometer();
    case Sensor::side:
      return plain.side;
    case Sensor::front:
      return plain.front;
    case Sensor::infrared:
      return plain.side || plain.front || (in_common && !listed.infrared.empty());
    case Sensor::ranger:
      return plain.ranger || (in_common && !listed.rangers.empty());
    case Sensor::none:
      break;
  }
  return true;
}

}  // namespace labmouse
