// Strict reading of the fields of a record's line.
#pragma once

#include <fmt/format.h>

#include <limits>
#include <string>
#include <string_view>

#include "labmouse/grid/cell.hpp"
#include "labmouse/grid/heading.hpp"
#include "labmouse/lab/text/former_names.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// Reads values from an object of a record and remembers the first missing or wrong one; returns a valid value in its
/// place.
class JsonFields {
 public:
  /// The object must outlive this one. `path` is its position in the line; empty for the line itself.
  JsonFields(const ReadJson& json, std::string path) : json_(json), path_(std::move(path)) {
    if (!json.is_object()) fail("is not an object");
  }

  /// The first error, or nothing.
  const std::string& error() const { return error_; }
  bool has(const char* key) const { return find(key) != nullptr; }
  void fail(const std::string& reason) {
    reject(path_.empty() ? "the line " + reason : fmt::format("'{}' {}", path_, reason));
  }
  /// The same, and returns the value that stands for the wrong one.
  template <class Value>
  Value fail(const std::string& reason, const Value& instead) {
    fail(reason);
    return instead;
  }
  /// Records a whole sentence as the error, such as one from another reader. An empty one changes nothing.
  void reject(const std::string& error) {
    if (error_.empty()) error_ = error;
  }

  /// Any value, by today's or the former name of the key. A missing value is an error and gives null.
  const ReadJson& value(const char* key) { return get(key); }
  std::string text(const char* key) {
    const ReadJson& value = get(key);
    if (value.is_string()) return value.get<std::string>();
    return wrong(key, "is not a string", std::string());
  }
  int whole(const char* key, int low, int high) { return whole(get(key), key, low, high); }
  /// The same for numbers beyond int, up to 2^53, which every JSON reader keeps exactly.
  std::int64_t long_whole(const char* key, std::int64_t low, std::int64_t high) {
    return long_whole(get(key), key, low, high);
  }
  std::int64_t long_whole(const ReadJson& value, const char* key, std::int64_t low, std::int64_t high) {
    if (!value.is_number_integer()) return wrong(key, "is not a whole number", low);
    const bool fits = !value.is_number_unsigned() || value.get<std::uint64_t>() <= std::uint64_t{1} << 53U;
    if (fits && value.get<std::int64_t>() >= low && value.get<std::int64_t>() <= high) return value.get<std::int64_t>();
    return wrong(key, fmt::format("is outside the range {} to {}", low, high), low);
  }
  double number(const char* key, double low, double high) {
    const ReadJson& value = get(key);
    if (!value.is_number()) return wrong(key, "is not a number", low);
    const double number = value.get<double>();
    if (number >= low && number <= high) return number;
    return wrong(key, fmt::format("is outside the range {} to {}", low, high), low);
  }
  double not_negative(const char* key) {
    const double value = number(key, std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max());
    if (value < 0) wrong(key, "must not be negative");
    return value;
  }
  bool flag(const char* key) {
    const ReadJson& value = get(key);
    if (value.is_boolean()) return value.get<bool>();
    return wrong(key, "is neither true nor false", false);
  }
  Cell cell(const char* key) { return cell(get(key), key); }
  Heading heading(const char* key) {
    const std::string name = text(key);
    for (const Heading heading : all_headings)
      if (name_of(heading) == name) return heading;
    return wrong(key, "is not one of north, east, south, west", Heading::north);
  }
  const ReadJson& list(const char* key) {
    static const ReadJson none = ReadJson::array();
    const ReadJson& value = get(key);
    if (value.is_array()) return value;
    return wrong(key, "is not a list", none);
  }
  int whole(const ReadJson& value, const char* key, int low, int high) {
    if (!value.is_number_integer()) return wrong(key, "is not a whole number", low);
    const bool fits = value.is_number_unsigned()
                          ? value.get<std::uint64_t>() <= static_cast<std::uint64_t>(std::numeric_limits<int>::max())
                          : value.get<std::int64_t>() >= std::numeric_limits<int>::min();
    if (fits && value.get<std::int64_t>() >= low && value.get<std::int64_t>() <= high) return value.get<int>();
    return wrong(key, fmt::format("is outside the range {} to {}", low, high), low);
  }
  Cell cell(const ReadJson& value, const char* key) {
    if (!value.is_array() || value.size() != 2) return wrong(key, "is not a cell [x, y]", Cell());
    return {whole(value[0], key, 0, max_side - 1), whole(value[1], key, 0, max_side - 1)};
  }

 private:
  const ReadJson& get(const char* key) {
    static const ReadJson nothing;
    if (const ReadJson* value = find(key)) return *value;
    return wrong(key, "is missing", nothing);
  }
  /// Finds a key under today's or its former name; null where it is missing.
  const ReadJson* find(const char* key) const {
    if (!json_.is_object()) return nullptr;
    auto found = json_.find(key);
    if (found == json_.end()) found = json_.find(std::string(former_key(key)));
    return found == json_.end() ? nullptr : &*found;
  }
  void wrong(const char* key, std::string_view reason) {
    if (error_.empty()) error_ = fmt::format("'{}{}{}' {}", path_, path_.empty() ? "" : ".", key, reason);
  }
  /// The same, and returns the value that stands for the wrong one.
  template <class Value>
  const Value& wrong(const char* key, std::string_view reason, const Value& instead) {
    wrong(key, reason);
    return instead;
  }
  /// Not for a list or object that is gone when it is returned.
  const ReadJson& wrong(const char* key, std::string_view reason, const ReadJson&& instead) = delete;

  const ReadJson& json_;
  std::string path_;
  std::string error_;
};

}  // namespace labmouse
