// A figure of a contest, a mouse or a maze, whatever world it comes from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

namespace labmouse {

/// Lists and objects, as a world writes them itself.
struct JsonText {
  std::string text;

  friend bool operator==(const JsonText&, const JsonText&) = default;
};

/// std::monostate says nothing at all and is left out of JSON; nullptr says that there is none, and is null there.
using Value = std::variant<std::monostate, std::nullptr_t, bool, std::int64_t, double, std::string, JsonText>;

/// A number, or that there is none.
Value or_none(const std::optional<double>& value);
Value or_none(const std::optional<std::int64_t>& value);
Value or_none(const std::optional<int>& value);

/// The number of a value, a truth counting 0 or 1; nothing where it is none.
std::optional<double> number_of(const Value& value);

/// As CSV has it: numbers with as few digits as give them back, nothing where there is none.
std::string text_of(const Value& value);

}  // namespace labmouse
