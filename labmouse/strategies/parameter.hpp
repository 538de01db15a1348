// Parameters of mice: declared once, in a table that the command line, the results and every other reader share.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace labmouse {

struct WallPrior;

/// A `prior` is one of its choices or else the path of a file that `labmouse learn` wrote.
enum class ParameterType : std::uint8_t { whole, real, flag, choice, list, prior };

std::string_view name_of(ParameterType type);

/// Where the parameter of a mouse makes a difference; `errors`: only in those worlds in seconds in which things go
/// wrong.
enum class ParameterScope : std::uint8_t { steps, seconds, both, errors };

/// One parameter of one mouse.
struct Parameter {
  std::string_view name;
  ParameterType type = ParameterType::whole;
  /// As it would be written in a SPEC: `3`, `0.5`, `yes`, `3/5/3`.
  std::string_view default_value;
  /// Smallest and largest value (of each element, for a list); without meaning for flags and choices.
  double low = 0.0;
  double high = 0.0;
  /// For a choice or a prior: what can be chosen, separated by `/`.
  std::string_view choices;
  std::string_view meaning;
  ParameterScope scope = ParameterScope::steps;

  static constexpr Parameter whole(std::string_view name, std::string_view value, double low, double high,
                                   std::string_view meaning, ParameterScope scope = ParameterScope::steps) {
    return {name, ParameterType::whole, value, low, high, {}, meaning, scope};
  }
  static constexpr Parameter real(std::string_view name, std::string_view value, double low, double high,
                                  std::string_view meaning, ParameterScope scope = ParameterScope::steps) {
    return {name, ParameterType::real, value, low, high, {}, meaning, scope};
  }
  static constexpr Parameter list(std::string_view name, std::string_view value, double low, double high,
                                  std::string_view meaning) {
    return {name, ParameterType::list, value, low, high, {}, meaning, ParameterScope::steps};
  }
  static constexpr Parameter flag(std::string_view name, std::string_view value, std::string_view meaning,
                                  ParameterScope scope = ParameterScope::steps) {
    return {name, ParameterType::flag, value, 0, 0, {}, meaning, scope};
  }
  static constexpr Parameter choice(std::string_view name, std::string_view value, std::string_view choices,
                                    std::string_view meaning, ParameterScope scope = ParameterScope::steps) {
    return {name, ParameterType::choice, value, 0, 0, choices, meaning, scope};
  }
  static constexpr Parameter prior(std::string_view name, std::string_view value, std::string_view choices,
                                   std::string_view meaning, ParameterScope scope = ParameterScope::steps) {
    return {name, ParameterType::prior, value, 0, 0, choices, meaning, scope};
  }
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

  /// Gives a prior that was learned (null takes it away): a mouse with a parameter of that type expects this in place
  /// of what the parameter's choice names. Strategies made under these settings use it: the settings must outlive them.
  void attach(std::shared_ptr<const WallPrior> prior) { prior_ = std::move(prior); }
  const WallPrior* attached() const { return prior_.get(); }

 private:
  std::vector<Setting> settings_;
  std::shared_ptr<const WallPrior> prior_;
};

/// What can be chosen of a choice or a prior, in the table's order.
std::vector<std::string_view> choices_of(const Parameter& parameter);

/// Why a value does not suit a parameter, as a line for the user; empty where it does. For a prior any path does: this
/// room opens no file.
std::string check_value(const Parameter& parameter, std::string_view value);

/// A value that has passed check_value in its one spelling: `3` for `03`, `0.5` for `.50`, `yes` for `true`.
std::string canonical_value(const Parameter& parameter, std::string_view value);

/// The candidate that is spelled most like a word, for "did you mean"; empty where none is near.
std::string_view nearest_name(std::string_view word, std::span<const std::string_view> candidates);

/// A decimal number such as `-12` or `0.25`, all of the text, without a power of ten; nothing where it is none, or a
/// double cannot hold it.
std::optional<double> parse_plain_number(std::string_view text);

}  // namespace labmouse
