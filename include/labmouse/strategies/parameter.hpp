// Parameters of mice. Each is declared once, in a table that command line, results and documentation use.
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

/// Type of a parameter. A `prior` is one of its choices or the path of a file from `labmouse learn`.
enum class ParameterType : std::uint8_t { whole, real, flag, choice, list, prior };

std::string_view name_of(ParameterType type);

/// The worlds in which a parameter has an effect; `errors`: only those in seconds with errors.
enum class ParameterScope : std::uint8_t { steps, seconds, both, errors };

/// One parameter of one mouse.
struct Parameter {
  std::string_view name;
  ParameterType type = ParameterType::whole;
  /// As written in a SPEC: `3`, `0.5`, `yes`, `3/5/3`.
  std::string_view default_value;
  /// Smallest and largest value (of each element, for a list); unused for flags and choices.
  double low = 0.0;
  double high = 0.0;
  /// For a choice or a prior: the choices, separated by `/`.
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

  /// The value of a parameter, which must be declared with that type.
  int whole(std::string_view name) const;
  double real(std::string_view name) const;
  bool flag(std::string_view name) const;
  std::string_view choice(std::string_view name) const;
  std::vector<double> list(std::string_view name) const;

  std::span<const Setting> all() const { return settings_; }

  /// Attaches a learned prior (null removes it), which replaces the choice of a parameter of type `prior`. The settings
  /// must outlive strategies made with them.
  void attach(std::shared_ptr<const WallPrior> prior) { prior_ = std::move(prior); }
  const WallPrior* attached() const { return prior_.get(); }

 private:
  std::vector<Setting> settings_;
  std::shared_ptr<const WallPrior> prior_;
};

/// The choices of a choice or a prior, in the table's order.
std::vector<std::string_view> choices_of(const Parameter& parameter);

/// Why a value is invalid for a parameter, as a message for the user; empty if it is valid. A prior may be any path,
/// because no file is opened here.
std::string check_value(const Parameter& parameter, std::string_view value);

/// The canonical spelling of a value that has passed check_value: `3` for `03`, `0.5` for `.50`, `yes` for `true`.
std::string canonical_value(const Parameter& parameter, std::string_view value);

/// The candidate with the most similar spelling, for "did you mean"; empty if none is similar.
std::string_view nearest_name(std::string_view word, std::span<const std::string_view> candidates);

/// Parses the whole text as a decimal number such as `-12` or `0.25`, without an exponent; nullopt if it is none or too
/// large for a double.
std::optional<double> parse_plain_number(std::string_view text);

}  // namespace labmouse
