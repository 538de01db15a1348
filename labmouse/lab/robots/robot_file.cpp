#include "labmouse/lab/robots/robot_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "labmouse/lab/robots/hardware_keys.hpp"
#include "labmouse/lab/robots/robot_keys.hpp"
#include "labmouse/lab/text/numbers.hpp"
#include "labmouse/lab/text/toml_text.hpp"
#include "labmouse/mouse/robot/straights.hpp"

namespace labmouse {
namespace {

/// A number as it stands in the file.
std::string written(const toml::node& number) {
  return number.is_integer() ? fmt::format("{}", number.as_integer()->get())
                             : fmt::format("{}", number.as_floating_point()->get());
}

/// The section and the rest of a key: "straight" and "speed"; no section for "cell".
std::pair<std::string_view, std::string_view> split(std::string_view key) {
  const auto dot = key.find('.');
  return dot == std::string_view::npos ? std::pair(std::string_view(), key)
                                       : std::pair(key.substr(0, dot), key.substr(dot + 1));
}

/// Reads numbers from a table and collects its problems.
class RobotReader {
 public:
  explicit RobotReader(const toml::table& root)
      : root_(root),
        forms_{
            node("turns") != nullptr,
            node("search.cell") != nullptr,
            flag("diagonals"),
            std::any_of(root.begin(), root.end(), [](const auto& entry) { return is_body_section(entry.first.str()); }),
            root.get(infrared_list) != nullptr,
            root.get(ranger_list) != nullptr} {
    for (const RobotKey& key : robot_keys()) read(key);
    if (forms_.infrared_list) read_list<Infrared>(infrared_list, infrared_keys(), most_infrared);
    if (forms_.ranger_list) read_list<Ranger>(ranger_list, ranger_keys(), most_rangers);
    for (const auto& [name, value] : root_) check_name("", name, value);
    check_rounding();
  }

  /// The number of a key, or `otherwise` where the key is missing or is no number.
  double number(std::string_view key, double otherwise = 0.0) const {
    const auto* found = node(key);
    return found == nullptr ? otherwise : found->value<double>().value_or(otherwise);
  }
  /// Whether a key has a number. Some keys may have `false` instead.
  bool has_number(std::string_view key) const { return node(key) != nullptr && node(key)->is_number(); }
  /// Whether a key is not false; true where it is missing.
  bool flag(std::string_view key) const {
    const auto* found = node(key);
    return found == nullptr || found->value_exact<bool>().value_or(true);
  }
  /// The text of a key, or `otherwise` where the key is missing or is no text.
  std::string_view text(std::string_view key, std::string_view otherwise) const {
    const auto* found = node(key);
    return found == nullptr ? otherwise : found->value<std::string_view>().value_or(otherwise);
  }
  const RobotForms& forms() const { return forms_; }

  /// Whether the file describes that sensor.
  bool has(RobotKey::Sensor sensor) const {
    using Sensor = RobotKey::Sensor;
    if (sensor == Sensor::none) return true;
    if (sensor == Sensor::infrared && !forms_.infrared_list) return has(Sensor::side) || has(Sensor::front);
    if (sensor == Sensor::infrared) return is_any_in(infrared_list);
    if (sensor == Sensor::ranger && forms_.ranger_list) return is_any_in(ranger_list);
    return std::any_of(robot_keys().begin(), robot_keys().end(), [&](const RobotKey& key) {
      return key.sensor == sensor && key.name.starts_with("sensors.") && node(key.name) != nullptr;
    });
  }

  /// The sensors of a list; `usual` has the numbers that may be left out.
  template <class Sensor>
  std::vector<Sensor> sensors(std::string_view list, std::span<const SensorKey<Sensor>> keys,
                              const Sensor& usual) const {
    std::vector<Sensor> all;
    for (const toml::node& entry : *root_.get(list)->as_array()) {
      Sensor& sensor = all.emplace_back(usual);
      for (const SensorKey<Sensor>& key : keys)
        if (const toml::node* found = entry.as_table()->get(key.key.name))
          key.number(sensor) = found->template value<double>().value_or(0.0);
    }
    return all;
  }

  std::vector<Problem> problems() const { return in_order(problems_); }

 private:
  /// A corner cannot be rounder than a circle.
  void check_rounding() {
    constexpr std::string_view key = "body.rounding";
    const double most = std::min(number("body.half_width"), (number("body.front") + number("body.back")) / 2.0);
    if (problems_.empty() && number(key) > most)
      add(node(key)->source().begin,
          fmt::format("'{}' is more than half the width or half the length of the chassis: {:g}", key, most));
  }

  bool is_any_in(std::string_view list) const {
    const toml::array* sensors = root_.get(list)->as_array();
    return sensors != nullptr && !sensors->empty();
  }

  const toml::node* node(std::string_view name) const {
    const RobotKey* key = find_robot_key(name);
    const toml::node* found = at(name);
    return found != nullptr || key == nullptr || key->former.empty() ? found : at(key->former);
  }

  const toml::node* at(std::string_view key) const {
    const auto [section, name] = split(key);
    if (section.empty()) return root_.get(name);
    const toml::node* table = root_.get(section);
    return table != nullptr && table->is_table() ? table->as_table()->get(name) : nullptr;
  }

  void add(const toml::source_position& place, std::string reason) {
    problems_.push_back(problem_at(place, std::move(reason)));
  }

  void read(const RobotKey& key) {
    const toml::node *found = node(key.name), *former = key.former.empty() ? nullptr : at(key.former);
    if (former != nullptr && former != found)
      add(former->source().begin,
          fmt::format("'{}' is the former name of '{}', which is in the file, too; delete one of them", key.former,
                      key.name));
    if (found == nullptr) return key.needed && forms_.has(key) && wants(key) ? missing(key) : void();
    if (!forms_.has(key)) return add(found->source().begin, fmt::format("'{}' {}", key.name, why_not(key, forms_)));
    using Kind = RobotKey::Kind;
    if (key.kind == Kind::yes_or_no)
      return found->is_boolean() ? void()
                                 : add(found->source().begin,
                                       fmt::format("'{}' must be true or false{}", key.name, diagonal_hint(*found)));
    if (key.kind == Kind::number_or_false && found->is_boolean() && !found->as_boolean()->get()) return;
    if (key.kind == Kind::choice) {
      const auto value = found->value<std::string_view>();
      return value && std::find(key.choices.begin(), key.choices.end(), *value) != key.choices.end()
                 ? void()
                 : add(found->source().begin, fmt::format("'{}' must be {}", key.name, range_of(key)));
    }
    read_number(key, *found);
  }

  void read_number(const RobotKey& key, const toml::node& found) {
    if (!found.is_number()) return add(found.source().begin, fmt::format("'{}' must be {}", key.name, words_of(key)));
    // A whole number too large for a double is out of any range.
    const double value = found.value<double>().value_or(std::numeric_limits<double>::infinity());
    if (key.name.ends_with("fall") && value > 0.0 && value < 1.0)
      return add(found.source().begin,
                 fmt::format("'{}' is {}; it must be 0, or 1 to {} mm", key.name, written(found), key.high));
    if (!(value >= key.low && value <= key.high) || (key.kind == RobotKey::Kind::whole && !found.is_integer()))
      add(found.source().begin, fmt::format("'{}' is {}; it must be {}{}", key.name, written(found), range_of(key),
                                            unit_hint(value, key.low, key.high, key.unit)));
  }

  /// Whether the robot has the sensor of a key.
  bool wants(const RobotKey& key) const {
    // Those of a list may each have numbers of their own.
    const bool usual = forms_.infrared_list && key.sensor == RobotKey::Sensor::infrared;
    return has(key.sensor) && !(usual && key.name.starts_with("sensors."));
  }

  template <class Sensor>
  void read_list(std::string_view list, std::span<const SensorKey<Sensor>> keys, std::size_t most) {
    const toml::node& node = *root_.get(list);
    const toml::array* entries = node.as_array();
    if (entries == nullptr || !(entries->empty() || entries->is_homogeneous(toml::node_type::table)))
      return add(node.source().begin, fmt::format("'{0}' must be a list of tables: [[{0}]]", list));
    if (entries->size() > most)
      return add(node.source().begin,
                 fmt::format("there are {} sensors in [[{}]]; a robot has at most {}", entries->size(), list, most));
    for (const toml::node& entry : *entries) read_entry(*entry.as_table(), list, keys);
  }

  template <class Sensor>
  void read_entry(const toml::table& entry, std::string_view list, std::span<const SensorKey<Sensor>> keys) {
    std::vector<std::string> names;
    for (const SensorKey<Sensor>& key : keys) {
      RobotKey named = key.key;
      const std::string name = fmt::format("{}.{}", list, named.name),
                        usual = fmt::format("sensors.{}_{}", list, named.name);
      names.push_back(name);
      named.name = name;
      if (const toml::node* found = entry.get(key.key.name))
        read_number(named, *found);
      else if (named.needed || (find_robot_key(usual) != nullptr && this->node(usual) == nullptr))
        add(entry.source().begin, fmt::format("missing key '{}': {}", name, range_of(named)));
    }
    const std::vector<std::string_view> known(names.begin(), names.end());
    for (const auto& [key, value] : entry)
      if (const std::string name = fmt::format("{}.{}", list, key.str());
          std::find(known.begin(), known.end(), name) == known.end())
        add(key.source().begin, unknown_key(name, known));
  }

  static std::string words_of(const RobotKey& key) {
    const std::string number = key.unit.empty() ? "a number" : fmt::format("a number, in {}", key.unit);
    if (key.kind == RobotKey::Kind::number_or_false) return number + ", or false";
    return key.name.ends_with(".S90") ? number + ": every robot drives S90" : number;
  }

  static std::string_view diagonal_hint(const toml::node& value) {
    return value.is_table() ? "; the limits of diagonals are in the table [diagonal]" : "";
  }

  void missing(const RobotKey& key) {
    const toml::node* section = root_.get(split(key.name).first);
    add(section != nullptr ? section->source().begin : toml::source_position{0, 0},
        fmt::format("missing key '{}': {}", key.name, range_of(key)));
  }

  void check_name(std::string_view section, const toml::key& key, const toml::node& value) {
    const std::string name = section.empty() ? std::string(key.str()) : fmt::format("{}.{}", section, key.str());
    if (name == infrared_list || name == ranger_list) return;
    if (section.empty() && is_section(name)) {
      if (!value.is_table()) return add(key.source().begin, fmt::format("'{0}' must be a table: [{0}]", name));
      for (const auto& [inner, inner_value] : *value.as_table()) check_name(name, inner, inner_value);
    } else if (!is_key(name)) {
      add(key.source().begin, unknown(name));
    }
  }

  static bool is_section(std::string_view name) {
    return std::any_of(robot_keys().begin(), robot_keys().end(),
                       [&](const RobotKey& key) { return split(key.name).first == name; });
  }
  static bool is_key(std::string_view name) {
    return find_robot_key(name) != nullptr || find_former_key(name) != nullptr;
  }

  static std::string unknown(const std::string& name) {
    std::vector<std::string_view> names;
    for (const RobotKey& key : robot_keys()) {
      names.push_back(key.name);
      if (const auto section = split(key.name).first; !section.empty()) names.push_back(section);
    }
    names.insert(names.end(), {infrared_list, ranger_list});
    return unknown_key(name, names);
  }

  const toml::table& root_;
  RobotForms forms_;
  std::vector<Problem> problems_;
};

DriveTime time_of(const RobotReader& reader, std::string_view key) { return microseconds(reader.number(key) / 1e3); }

FixedTimes fixed_times(const RobotReader& reader) {
  return {reader.number("turns.speed"), time_of(reader, "turns.45"),  time_of(reader, "turns.90"),
          time_of(reader, "turns.135"), time_of(reader, "turns.180"), time_of(reader, "turns.V90"),
          time_of(reader, "turns.S90")};
}

SearchDrive search_times(const RobotReader& reader) {
  return {time_of(reader, "search.cell"), time_of(reader, "search.turn"), time_of(reader, "search.back"),
          time_of(reader, "search.quarter"), time_of(reader, "search.half_cell")};
}

/// The profile of that name; the first one if there is none.
TurnProfile profile_of(std::string_view name) {
  const auto* const found = std::find(turn_profile_names.begin(), turn_profile_names.end(), name);
  return found == turn_profile_names.end() ? TurnProfile{}
                                           : static_cast<TurnProfile>(found - turn_profile_names.begin());
}

void set_layouts(Robot& robot, const RobotReader& reader) {
  const std::string_view section = reader.forms().turns ? "turns" : "layout";
  for (const Turn turn : {Turn::f45, Turn::f90, Turn::f135, Turn::f180, Turn::v90, Turn::s90}) {
    const std::string key = fmt::format("{}.{}", section, name_of(turn));
    robot.layouts[static_cast<unsigned>(turn)] = {reader.flag(key), reader.forms().turns ? 0.0 : reader.number(key)};
  }
}

Hardware hardware_of(const RobotReader& reader) {
  using Sensor = RobotKey::Sensor;
  HardwareNumbers numbers;
  // The noise of a sensor that it lacks is none.
  for (const HardwareKey& key : hardware_keys())
    if (reader.has_number(key.key.name) && reader.has(key.key.sensor))
      key.number(numbers) = reader.number(key.key.name) / key.unit;
  const RobotForms& forms = reader.forms();
  Hardware hardware = hardware_of(
      numbers, {!forms.infrared_list && reader.has(Sensor::side), !forms.infrared_list && reader.has(Sensor::front),
                !forms.ranger_list && reader.has(Sensor::ranger)});
  Sensors& sensors = hardware.sensors;
  if (forms.infrared_list) sensors.infrared = reader.sensors(infrared_list, infrared_keys(), numbers.infrared);
  if (forms.ranger_list) sensors.rangers = reader.sensors(ranger_list, ranger_keys(), numbers.ranger);
  return hardware;
}

Robot robot_of(const RobotReader& reader, std::string_view name, RobotText kind) {
  Robot robot;
  robot.name = name;
  robot.cell = reader.number("cell");
  robot.speed = reader.number("straight.speed");
  robot.acceleration = reader.number("straight.acceleration");
  robot.braking = reader.number("straight.braking", robot.acceleration);
  robot.speed_diagonal = reader.number("diagonal.speed", robot.speed);
  robot.acceleration_diagonal = reader.number("diagonal.acceleration", robot.acceleration);
  robot.braking_diagonal = reader.number(
      "diagonal.braking", reader.has_number("diagonal.acceleration") ? robot.acceleration_diagonal : robot.braking);
  robot.diagonals = reader.forms().diagonals;
  robot.lateral_acceleration = reader.number("curve.lateral_acceleration");
  robot.yaw_acceleration = reader.number("curve.yaw_acceleration");
  robot.yaw_speed = reader.number("curve.yaw_speed");
  robot.yaw_jerk = reader.number("curve.yaw_jerk");
  robot.profile = profile_of(reader.text("curve.profile", ""));
  robot.grip = reader.number("curve.grip");
  robot.clearance = reader.number("clearance");
  robot.run_up = reader.number("run_up");
  const bool recorded = kind == RobotText::recorded;
  robot.speeds = static_cast<int>(reader.number("curve.speeds", recorded ? recorded_speeds : robot.speeds));
  robot.stop = reader.text("stop", recorded ? "beyond" : "goal") == "beyond" ? Stop::beyond : Stop::goal;
  robot.sight = static_cast<int>(reader.number("sight", 1.0));
  robot.search_speed = reader.number("search.speed");
  robot.search_turn_speed = reader.number("search.turn_speed");
  robot.known_speed = reader.number("search.known_speed");
  robot.known_acceleration = reader.number("search.known_acceleration");
  robot.pivot_speed = reader.number("search.pivot_speed");
  robot.pivot_acceleration = reader.number("search.pivot_acceleration");
  set_layouts(robot, reader);
  if (reader.forms().turns) robot.fixed = fixed_times(reader);
  if (reader.forms().search_times) robot.search = search_times(reader);
  if (reader.forms().body) robot.hardware = hardware_of(reader);
  return robot;
}

}  // namespace

RobotResult read_robot(std::string_view text, std::string_view name, RobotText kind) {
  const auto failure = [](std::vector<Problem> problems) { return RobotResult{std::nullopt, {}, std::move(problems)}; };
  const TomlText toml = parse_toml(text);
  if (!toml.problems.empty()) return failure(toml.problems);
  RobotReader reader(toml.table);
  if (auto problems = reader.problems(); !problems.empty()) return failure(std::move(problems));
  Robot robot = robot_of(reader, name, kind);
  DriveModel model = make_drive_model(robot);
  if (!model.error.empty()) return failure({{0, 0, model.error}});
  return {std::move(robot), std::move(model), {}};
}

}  // namespace labmouse
