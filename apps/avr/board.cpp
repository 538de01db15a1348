#include "board.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "labmouse/functions/parse_number.hpp"
#include "labmouse/lab/text/toml_fields.hpp"

namespace labmouse::avr {
namespace {

constexpr std::array<std::string_view, 9> board_keys = {"chip",     "frequency", "supply", "left",   "right",
                                                        "infrared", "battery",   "press",  "signals"};
constexpr std::array<std::string_view, 8> wheel_keys = {"pwm", "back_pwm", "direction", "ahead",
                                                        "a",   "clock",    "b",         "leading"};
constexpr std::array<std::string_view, 4> receiver_keys = {"pin", "emitter", "scale", "ambient"};
constexpr std::array<std::string_view, 2> battery_keys = {"pin", "divider"};
constexpr std::array<std::string_view, 5> press_keys = {"pin", "released", "pressed", "at", "hold"};
constexpr std::array<std::string_view, 3> signal_keys = {"goal", "fast", "carried"};
/// Where timers put out PWM.
constexpr std::array<std::string_view, 6> pwm_pins = {"D3", "D5", "D6", "D9", "D10", "D11"};

constexpr int longest_time = 3'600'000, most_voltage = 5'500;

/// Reads the tables of a board file, and collects their problems.
class BoardReader {
 public:
  BoardResult read(const toml::table& file) {
    fields_.refuse_unknown(file, board_keys);
    Board board;
    board.chip = word(file, "chip", {"atmega328p", "atmega328"}, "atmega328p");
    board.frequency = fields_.whole(file, "frequency", 1'000'000, 20'000'000).value_or(board.frequency);
    board.supply = fields_.whole(file, "supply", 1'800, most_voltage).value_or(board.supply);
    board.wheels = {wheel(file, "left"), wheel(file, "right")};
    for (const toml::table* each : tables(file, "infrared")) board.receivers.push_back(receiver(*each));
    for (const toml::table* each : tables(file, "press")) board.presses.push_back(press(*each));
    if (const toml::table* battery = table(file, "battery")) {
      fields_.refuse_unknown(*battery, battery_keys);
      board.battery = analog(*battery, "pin");
      board.divider = fields_.number(*battery, "divider", 1.0, 100.0).value_or(board.divider);
    }
    if (const toml::table* signals = table(file, "signals")) {
      fields_.refuse_unknown(*signals, signal_keys);
      board.goal = optional_digital(*signals, "goal");
      board.fast = optional_digital(*signals, "fast");
      board.carried_resets = word(*signals, "carried", {"reset", "press"}, "reset") == "reset";
    }
    if (!fields_.good()) return {{}, fields_.problems()};
    return {board, {}};
  }

 private:
  Wheel wheel(const toml::table& file, std::string_view name) {
    const toml::table* found = table(file, name);
    Wheel wheel;
    if (found == nullptr) {
      if (!file.contains(name))
        fields_.add({1, 1}, fmt::format("has no table [{}], the pins of the {} wheel", name, name));
      return wheel;
    }
    fields_.refuse_unknown(*found, wheel_keys);
    wheel.pwm = pwm(*found, "pwm");
    if (found->contains("back_pwm")) wheel.back_pwm = pwm(*found, "back_pwm");
    wheel.direction = optional_digital(*found, "direction");
    if (wheel.back_pwm.has_value() == wheel.direction.has_value())
      fields_.add(found->source().begin, "needs one of 'direction' and 'back_pwm', and not both");
    wheel.ahead_is_high = word(*found, "ahead", {"high", "low"}, "high") == "high";
    wheel.is_clock = found->contains("clock");
    if (wheel.is_clock == found->contains("a"))
      fields_.add(found->source().begin, "needs one of 'a' and 'clock' (a xor b), and not both");
    else
      wheel.a = digital(*found, wheel.is_clock ? "clock" : "a");
    wheel.b = digital(*found, "b");
    wheel.a_leads = word(*found, "leading", {"a", "b"}, "a") == "a";
    return wheel;
  }

  Receiver receiver(const toml::table& table) {
    fields_.refuse_unknown(table, receiver_keys);
    constexpr double most_counts = 1023.0;
    Receiver receiver;
    receiver.pin = analog(table, "pin");
    receiver.emitter = optional_digital(table, "emitter");
    receiver.scale = fields_.number(table, "scale", 0.0001, 1000.0).value_or(receiver.scale);
    receiver.ambient = fields_.number(table, "ambient", 0.0, most_counts, " of counts").value_or(receiver.ambient);
    return receiver;
  }

  Press press(const toml::table& table) {
    fields_.refuse_unknown(table, press_keys);
    const auto number = [&](std::string_view key, int most) {
      if (!table.contains(key)) fields_.add(table.source().begin, fmt::format("has no '{}'", key));
      return fields_.whole(table, key, 0, most).value_or(0);
    };
    Press press;
    press.pin = pin(table, "pin").value_or(Pin());
    press.released = fields_.whole(table, "released", 0, most_voltage).value_or(0);
    press.pressed = number("pressed", most_voltage);
    press.at = number("at", longest_time);
    press.hold = number("hold", longest_time);
    return press;
  }

  /// A table of that name; null where there is none, or something else.
  const toml::table* table(const toml::table& file, std::string_view name) {
    const toml::node* node = file.get(name);
    if (node != nullptr && !node->is_table())
      fields_.add(node->source().begin, fmt::format("'{0}' must be a table, which begins with a line [{0}]", name));
    return node == nullptr ? nullptr : node->as_table();
  }

  std::vector<const toml::table*> tables(const toml::table& file, std::string_view name) {
    const toml::node* node = file.get(name);
    if (node == nullptr) return {};
    const toml::array* array = node->as_array();
    constexpr std::size_t most = 16;
    if (array == nullptr || array->size() > most || !array->is_homogeneous<toml::table>()) {
      fields_.add(node->source().begin,
                  fmt::format("'{0}' must be at most {1} tables; each begins with a line [[{0}]]", name, most));
      return {};
    }
    std::vector<const toml::table*> all;
    for (const toml::node& each : *array) all.push_back(each.as_table());
    return all;
  }

  std::string word(const toml::table& table, std::string_view key, std::array<std::string_view, 2> words,
                   std::string_view usual) {
    if (!table.contains(key)) return std::string(usual);
    std::string text = fields_.text(table, key);
    if (!text.empty() && std::find(words.begin(), words.end(), text) == words.end())
      fields_.add(table.get(key)->source().begin,
                  fmt::format("'{}' must be \"{}\" or \"{}\"", key, words[0], words[1]));
    return text;
  }

  std::optional<Pin> pin(const toml::table& table, std::string_view key) {
    if (!table.contains(key)) {
      fields_.add(table.source().begin, fmt::format("has no '{}'", key));
      return std::nullopt;
    }
    const std::string name = fields_.text(table, key);
    auto found = find_pin(name);
    if (!found && !name.empty())
      fields_.add(table.get(key)->source().begin,
                  fmt::format("'{}' must be a pin: \"D0\" to \"D13\", \"A0\" to \"A7\", or \"PB0\" to \"PD7\"", key));
    return found;
  }

  Pin digital(const toml::table& table, std::string_view key) {
    const auto found = pin(table, key);
    if (found && found->port == 0)
      fields_.add(table.get(key)->source().begin, fmt::format("'{}' must be a digital pin; this one is analog", key));
    return found.value_or(Pin());
  }

  std::optional<Pin> optional_digital(const toml::table& table, std::string_view key) {
    return table.contains(key) ? std::optional(digital(table, key)) : std::nullopt;
  }

  Pin analog(const toml::table& table, std::string_view key) {
    const auto found = pin(table, key);
    if (found && found->channel < 0)
      fields_.add(table.get(key)->source().begin, fmt::format("'{}' must be a pin of the ADC: \"A0\" to \"A7\"", key));
    return found.value_or(Pin());
  }

  Pin pwm(const toml::table& table, std::string_view key) {
    const auto found = pin(table, key);
    if (found &&
        std::none_of(pwm_pins.begin(), pwm_pins.end(), [&](std::string_view name) { return find_pin(name) == found; }))
      fields_.add(table.get(key)->source().begin,
                  fmt::format("'{}' must be a pin with PWM: {}", key, fmt::join(pwm_pins, ", ")));
    return found.value_or(Pin());
  }

  TomlFields fields_;
};

}  // namespace

std::optional<Pin> find_pin(std::string_view name) {
  constexpr int first_of_b = 8, last_digital = 13, last_analog = 7, last_of_c = 5;
  if (name.size() == 3 && name[0] == 'P' && name[1] >= 'B' && name[1] <= 'D') {
    const auto bit = parse_whole<int>(name.substr(2));
    const int most = name[1] == 'D' ? 7 : 5;
    if (!bit || *bit < 0 || *bit > most) return std::nullopt;
    return Pin{name[1], *bit, name[1] == 'C' ? *bit : -1};
  }
  if (name.size() < 2) return std::nullopt;
  const auto number = parse_whole<int>(name.substr(1));
  if (!number || *number < 0) return std::nullopt;
  if (name[0] == 'D' && *number < first_of_b) return Pin{'D', *number, -1};
  if (name[0] == 'D' && *number <= last_digital) return Pin{'B', *number - first_of_b, -1};
  if (name[0] == 'A' && *number <= last_of_c) return Pin{'C', *number, *number};
  if (name[0] == 'A' && *number <= last_analog) return Pin{0, 0, *number};
  return std::nullopt;
}

BoardResult read_board(std::string_view text) {
  TomlText parsed = parse_toml(text);
  if (!parsed.problems.empty()) return {{}, std::move(parsed.problems)};
  return BoardReader().read(parsed.table);
}

}  // namespace labmouse::avr
