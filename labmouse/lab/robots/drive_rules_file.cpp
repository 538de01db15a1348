#include "labmouse/lab/robots/drive_rules_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/robots/builtin_rules.hpp"
#include "labmouse/lab/robots/drive_rules_keys.hpp"
#include "labmouse/lab/system/named_text.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/lab/text/toml_text.hpp"

namespace labmouse {
namespace {

constexpr std::string_view gate_to_gate = "gate to gate", rest_to_centre = "rest to centre";

/// What the value of a key must be.
std::string form_of(const DriveRulesKey& key) {
  if (!key.form.empty()) return std::string(key.form);
  const bool whole = std::holds_alternative<int DriveRules::*>(key.member);
  return fmt::format("a {} from {} to {}", whole ? "whole number" : "number of seconds", key.low, key.high);
}

/// Reads rules from a table and collects its problems.
class RulesReader {
 public:
  explicit RulesReader(const toml::table& table) : table_(table) {
    std::array<std::string_view, drive_rules_keys.size()> names;
    std::transform(drive_rules_keys.begin(), drive_rules_keys.end(), names.begin(),
                   [](const DriveRulesKey& key) { return key.name; });
    for (const auto& [key, value] : table)
      if (std::find(names.begin(), names.end(), key.str()) == names.end())
        add(key.source().begin, unknown_key(std::string(key.str()), names));
  }

  /// If there are problems, the rules are not to be used.
  DriveRules read() {
    DriveRules rules;
    for (const DriveRulesKey& key : drive_rules_keys)
      std::visit([&](auto member) { read(key, rules.*member); }, key.member);
    return rules;
  }

  std::vector<Problem> problems() const { return in_order(problems_); }

 private:
  void read(const DriveRulesKey& key, Counted& counts) {
    if (!table_.contains(key.name)) return;
    const std::string value = text(key);
    counts_ = counted_named(value);
    if (!counts_ && !value.empty()) refuse(key, form_of(key));
    counts = counts_.value_or(Counted::run);
  }

  void read(const DriveRulesKey& key, std::string& value) { value = shown(text(key)); }

  void read(const DriveRulesKey& key, bool& from_gate_to_gate) {
    const std::string value = text(key);
    from_gate_to_gate = value == gate_to_gate;
    if (!value.empty() && value != gate_to_gate && value != rest_to_centre) refuse(key, form_of(key));
    if (value == rest_to_centre && counts_ && *counts_ != Counted::run)
      refuse(key, fmt::format("\"gate to gate\" with counts = \"{}\"", name_of(*counts_)));
  }

  template <class Number>
  void read(const DriveRulesKey& key, Number& value) {
    const toml::node* node = table_.get(key.name);
    if (!counts_) return;
    if (!key.goes_with(*counts_)) {
      if (node != nullptr)
        add(node->source().begin,
            fmt::format("'{}' does not go with counts = \"{}\"; remove it", key.name, name_of(*counts_)));
      return;
    }
    if (node == nullptr) {
      if (key.needed) add_missing(key);
      return;
    }
    const double number = node->value<double>().value_or(std::nan(""));
    const bool right_type = std::is_same_v<Number, int> ? node->is_integer() : node->is_number();
    if (!right_type || !(number >= key.low && number <= key.high)) return refuse(key, form_of(key));
    value = static_cast<Number>(std::floor(number * static_cast<double>(units_of<Number>) + 0.5));
  }

  /// The text of a required key, which must not be empty.
  std::string text(const DriveRulesKey& key) {
    const toml::node* node = table_.get(key.name);
    if (node == nullptr) {
      add_missing(key);
      return "";
    }
    std::string value = node->value<std::string>().value_or("");
    if (value.empty()) refuse(key, form_of(key));
    return value;
  }

  void add_missing(const DriveRulesKey& key) {
    add({0, 0}, fmt::format("missing key '{}': {}", key.name, form_of(key)));
  }
  void refuse(const DriveRulesKey& key, std::string_view form) {
    add(table_.get(key.name)->source().begin, fmt::format("'{}' must be {}", key.name, form));
  }
  void add(const toml::source_position& place, std::string reason) {
    problems_.push_back(problem_at(place, std::move(reason)));
  }

  const toml::table& table_;
  /// "run" if the key is missing; nothing if it is wrong, and then no number is refused for it.
  std::optional<Counted> counts_ = Counted::run;
  std::vector<Problem> problems_;
};

}  // namespace

DriveRulesResult read_drive_rules(std::string_view text, std::string_view name) {
  const TomlText toml = parse_toml(text);
  if (!toml.problems.empty()) return {std::nullopt, toml.problems};
  RulesReader reader(toml.table);
  DriveRules rules = reader.read();
  rules.name = name;
  if (auto problems = reader.problems(); !problems.empty()) return {std::nullopt, std::move(problems)};
  return {std::move(rules), {}};
}

FoundRules find_rules(const std::string& name) {
  const NamedText found = find_text("rules", builtin_rules(), name);
  const std::string called = name_alone(name);
  if (!found.error.empty()) return {{}, {found.error}};
  DriveRulesResult read = read_drive_rules(found.text, called);
  if (read.rules) return {std::move(*read.rules), {}};
  FoundRules none;
  for (const Problem& problem : read.problems) none.errors.push_back(describe(called, problem));
  return none;
}

}  // namespace labmouse
