// A figure of a contest, a mouse or a maze, whatever world it comes from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>

namespace labmouse {

/// Lists and objects, as a world writes them itself.
struct JsonText {
  std::string text;

  friend bool operator==(const JsonText&, const JsonText&) = default;
};

/// A field with std::monostate is left out of JSON; nullptr, for a figure without a value, is null there.
using Value = std::variant<std::monostate, std::nullptr_t, bool, std::int64_t, double, std::string, JsonText>;

/// A number that the clock of a machine made: it differs from race to race.
struct ByClock {
  double number = 0.0;
};

/// A member of a struct that is left out of JSON where it has no value; one of std::optional is null there.
template <class T>
struct LeftOut : std::optional<T> {
  using std::optional<T>::optional;
};

/// The value of a member of a struct: a number, a bool, a text, JSON, or an optional one of these.
template <class T>
Value value_of(const T& member) {
  return member;
}
inline Value value_of(int member) { return std::int64_t{member}; }
inline Value value_of(const ByClock& member) { return member.number; }
template <class T>
Value value_of(const std::optional<T>& member) {
  return member ? value_of(*member) : Value(nullptr);
}
template <class T>
Value value_of(const LeftOut<T>& member) {
  return member ? value_of(*member) : Value();
}

/// Sets a member to such a value; false where the value is of another kind.
template <class T>
bool set_to(const Value& value, T& member) {
  const auto* held = std::get_if<std::conditional_t<std::is_same_v<T, int>, std::int64_t, T>>(&value);
  if (held != nullptr) member = static_cast<T>(*held);
  return held != nullptr;
}
template <class T>
requires requires(T& optional) { optional.reset(); }
bool set_to(const Value& value, T& member) {
  member.reset();
  return value == value_of(member) || set_to(value, member.emplace());
}
inline bool set_to(const Value& value, ByClock& member) { return set_to(value, member.number); }

/// The number of a value, with false as 0 and true as 1; nothing if it is not a number.
std::optional<double> number_of(const Value& value);

/// As CSV has it: numbers with as few digits as give them back, nothing where there is none.
std::string text_of(const Value& value);

}  // namespace labmouse
