// Reads the values of a TOML file and collects what is wrong with them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/text/toml_text.hpp"

namespace labmouse {

/// The problems of one TOML file. Each reader returns an empty value for a key that is missing or wrong, and notes a
/// problem for a wrong one.
class TomlFields {
 public:
  void add(const toml::key& key, std::string reason) { add(key.source().begin, std::move(reason)); }
  void add(const toml::source_position& place, std::string reason);
  bool good() const { return problems_.empty(); }
  /// In the order of the file, at most as many as are printed.
  std::vector<Problem> problems() const { return in_order(problems_); }

  void refuse_unknown(const toml::table& table, std::span<const std::string_view> known);

  /// A printable text that is not empty.
  std::string text(const toml::table& table, std::string_view key);
  /// Texts without zero bytes; `example` is shown where it is no list of these.
  std::vector<std::string> texts(const toml::table& table, std::string_view key, std::string_view example);
  bool flag(const toml::table& table, std::string_view key);
  std::optional<int> whole(const toml::table& table, std::string_view key, int low, int high);
  /// `unit` stands behind "a number", as in " of seconds".
  std::optional<double> number(const toml::table& table, std::string_view key, double low, double high,
                               std::string_view unit = "");

 private:
  std::vector<Problem> problems_;
};

}  // namespace labmouse
