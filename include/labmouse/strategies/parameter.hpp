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

/// The type in words, for help texts.
/// @param type one of the types.
/// @return "whole number", "yes/no"; in static memory.
std::string_view name_of(ParameterType type);

/// The worlds in which a parameter has an effect; `errors`: only those in seconds with errors.
enum class ParameterScope : std::uint8_t { steps, seconds, both, errors };

/// One parameter of one mouse.
struct Parameter {
  /// As in a SPEC.
  std::string_view name;
  ParameterType type = ParameterType::whole;
  /// As written in a SPEC: `3`, `0.5`, `yes`, `3/5/3`.
  std::string_view default_value;
  /// Smallest and largest value (of each element, for a list); unused for flags and choices.
  double low = 0.0;
  double high = 0.0;
  /// For a choice or a prior: the choices, separated by `/`.
  std::string_view choices;
  /// What it does, for help texts: a sentence.
  std::string_view meaning;
  ParameterScope scope = ParameterScope::steps;

  /// A whole number. The texts of this and the following ones must outlive the parameter.
  /// @param name as in a SPEC.
  /// @param value the default, as written in a SPEC.
  /// @param low the smallest value.
  /// @param high the largest value.
  /// @param meaning for help texts.
  /// @param scope the worlds in which it has an effect.
  static constexpr Parameter whole(std::string_view name, std::string_view value, double low, double high,
                                   std::string_view meaning, ParameterScope scope = ParameterScope::steps) {
    return {name, ParameterType::whole, value, low, high, {}, meaning, scope};
  }
  /// A real number.
  /// @param name as in a SPEC.
  /// @param value the default, as written in a SPEC.
  /// @param low the smallest value.
  /// @param high the largest value.
  /// @param meaning for help texts.
  /// @param scope the worlds in which it has an effect.
  static constexpr Parameter real(std::string_view name, std::string_view value, double low, double high,
                                  std::string_view meaning, ParameterScope scope = ParameterScope::steps) {
    return {name, ParameterType::real, value, low, high, {}, meaning, scope};
  }
  /// A list of numbers, for the world of steps.
  /// @param name as in a SPEC.
  /// @param value the default, with as many elements as each value: `3/5/3`.
  /// @param low the smallest value of each element.
  /// @param high the largest value of each element.
  /// @param meaning for help texts.
  static constexpr Parameter list(std::string_view name, std::string_view value, double low, double high,
                                  std::string_view meaning) {
    return {name, ParameterType::list, value, low, high, {}, meaning, ParameterScope::steps};
  }
  /// A flag.
  /// @param name as in a SPEC.
  /// @param value the default, `yes` or `no`.
  /// @param meaning for help texts.
  /// @param scope the worlds in which it has an effect.
  static constexpr Parameter flag(std::string_view name, std::string_view value, std::string_view meaning,
                                  ParameterScope scope = ParameterScope::steps) {
    return {name, ParameterType::flag, value, 0, 0, {}, meaning, scope};
  }
  /// A choice.
  /// @param name as in a SPEC.
  /// @param value the default, one of the choices.
  /// @param choices all of them, separated by `/`.
  /// @param meaning for help texts.
  /// @param scope the worlds in which it has an effect.
  static constexpr Parameter choice(std::string_view name, std::string_view value, std::string_view choices,
                                    std::string_view meaning, ParameterScope scope = ParameterScope::steps) {
    return {name, ParameterType::choice, value, 0, 0, choices, meaning, scope};
  }
  /// A prior: one of its choices, or the path of a file.
  /// @param name as in a SPEC.
  /// @param value the default, one of the choices.
  /// @param choices all of them, separated by `/`.
  /// @param meaning for help texts.
  /// @param scope the worlds in which it has an effect.
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
  /// Without parameters.
  Settings() = default;
  /// The defaults of a table.
  /// @param parameters of one mouse; copied.
  explicit Settings(std::span<const Parameter> parameters);

  /// Sets the value of a parameter.
  /// @param name of a parameter of the table.
  /// @param value one that has passed check_value.
  void set(std::string_view name, std::string_view value);

  /// The value of a whole number.
  /// @param name of a parameter of type `whole` in the table.
  int whole(std::string_view name) const;
  /// The value of a real number.
  /// @param name of a parameter of type `real` in the table.
  double real(std::string_view name) const;
  /// The value of a flag.
  /// @param name of a parameter of type `flag` in the table.
  bool flag(std::string_view name) const;
  /// The value of a choice or a prior, as text.
  /// @param name of a parameter in the table.
  /// @return valid until it is set again.
  std::string_view choice(std::string_view name) const;
  /// The elements of a list.
  /// @param name of a parameter of type `list` in the table.
  /// @return as many as its default has.
  std::vector<double> list(std::string_view name) const;

  /// All values, in the order of the table.
  std::span<const Setting> all() const { return settings_; }

  /// Attaches a learned prior, which replaces the choice of a parameter of type `prior`.
  /// @param prior null removes it. The settings must outlive strategies made with them.
  void attach(std::shared_ptr<const WallPrior> prior) { prior_ = std::move(prior); }
  /// The attached prior; null if there is none.
  const WallPrior* attached() const { return prior_.get(); }

 private:
  std::vector<Setting> settings_;
  std::shared_ptr<const WallPrior> prior_;
};

/// The choices of a choice or a prior.
/// @param parameter of one of these types.
/// @return in the table's order, as parts of its `choices`.
std::vector<std::string_view> choices_of(const Parameter& parameter);

/// Checks a value for a parameter. A prior may be any path, because no file is opened here.
/// @param parameter its type, range and choices.
/// @param value as written in a SPEC; any text.
/// @return empty if it is valid; otherwise the reason, to follow the name of the parameter: "is not a number".
std::string check_value(const Parameter& parameter, std::string_view value);

/// The canonical spelling of a value: `3` for `03`, `0.5` for `.50`, `yes` for `true`. Choices and priors stay as they
/// are.
/// @param parameter its type.
/// @param value one that has passed check_value.
std::string canonical_value(const Parameter& parameter, std::string_view value);

/// Finds the name that a user may have meant, for "did you mean".
/// @param word what the user wrote.
/// @param candidates all names.
/// @return the first candidate with the fewest edits (letters inserted, deleted or replaced), which must be at most 2,
///   or half the length of the word. If there is none and the word has 3 letters or more, the first candidate that
///   contains it. Otherwise empty.
std::string_view nearest_name(std::string_view word, std::span<const std::string_view> candidates);

/// Parses a decimal number such as `-12` or `0.25`, without an exponent.
/// @param text the whole of it must be the number, without spaces and without `+`.
/// @return the nearest double; nullopt if it is no such number, or too large or too close to 0 for a double.
std::optional<double> parse_plain_number(std::string_view text);

}  // namespace labmouse
