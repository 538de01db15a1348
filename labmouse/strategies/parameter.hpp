// Parameters of mice: declared once, in a table that the command line, the results and every other reader share.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace labmouse {

enum class ParameterType : std::uint8_t { whole, real, flag, choice, list };

std::string_view name_of(ParameterType type);

/// One parameter of one mouse.
struct Parameter {
  std::string_view name;
  ParameterType type = ParameterType::whole;
  /// As it would be written in a SPEC: `3`, `0.5`, `yes`, `3/5/3`.
  std::string_view default_value;
  /// Smallest and largest value (of each element, for a list); without meaning for flags and choices.
  double low = 0.0;
  double high = 0.0;
  /// For a choice: what can be chosen, separated by `/`.
  std::string_view choices;
  std::string_view meaning;
};

/// A parameter with a value, both as text; the value has passed check_value.
struct Setting {
  std::string name;
  std::string value;

  friend bool operator==(const Setting&, const Setting&) = default;
};

/// Values for all parameters of one mouse, in the order of its table.
class Settings {
 public:
  Settings() = default;
  /// The defaults of a table.
  explicit Settings(std::span<const Parameter> parameters);

  /// Sets a value that has passed check_value.
  void set(std::string_view name, std::string_view value);

  /// A value by its parameter's name, which must be declared, as the type that it was declared with.
  int whole(std::string_view name) const;
  double real(std::string_view name) const;
  bool flag(std::string_view name) const;
  std::string_view choice(std::string_view name) const;
  std::vector<double> list(std::string_view name) const;

  std::span<const Setting> all() const { return settings_; }

 private:
  std::vector<Setting> settings_;
};

/// What can be chosen of a choice, in the table's order.
std::vector<std::string_view> choices_of(const Parameter& parameter);

/// Why a value does not suit a parameter, as a line for the user; empty where it does.
std::string check_value(const Parameter& parameter, std::string_view value);

/// A value that has passed check_value in its one spelling: `3` for `03`, `0.5` for `.50`, `yes` for `true`.
std::string canonical_value(const Parameter& parameter, std::string_view value);

/// The candidate that is spelled most like a word, for "did you mean"; empty where none is near.
std::string_view nearest_name(std::string_view word, std::span<const std::string_view> candidates);

/// Reads a decimal number such as `-12` or `0.25`, all of it or nothing; the same on every platform.
bool parse_number(std::string_view text, double& number);

}  // namespace labmouse
