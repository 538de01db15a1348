#include "labmouse/lab/robots/drive_rules_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/robots/builtin_rules.hpp"
#include "labmouse/lab/system/named_text.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/lab/text/toml_text.hpp"

namespace labmouse {
namespace {

/// A number in a file of rules; times are in seconds.
struct RulesNumber {
  std::string_view name;
  double low = 0.0;
  double high = 0.0;
  bool whole = false;
  bool needed = false;
};

constexpr RulesNumber time_limit = {.name = "time_limit", .low = 1, .high = 7200, .needed = true};
constexpr RulesNumber runs = {.name = "runs", .low = 1, .high = 100, .whole = true, .needed = true};
constexpr RulesNumber laps = {.name = "laps", .low = 1, .high = 20, .whole = true, .needed = true};
constexpr RulesNumber marks = {.name = "marks", .low = 1, .high = most_marks, .whole = true, .needed = true};
constexpr RulesNumber maze_time_divisor = {.name = "maze_time_divisor", .low = 1, .high = 1000, .whole = true};
constexpr RulesNumber touch_penalty = {.name = "touch_penalty", .high = 600};
constexpr RulesNumber untouched_bonus = {.name = "untouched_bonus", .high = 600};

constexpr std::array<std::string_view, 10> rule_keys = {
    "source",        "time_limit",      "counts", "runs", "laps", "marks", "maze_time_divisor",
    "touch_penalty", "untouched_bonus", "clock"};
constexpr std::array all_counted = {Counted::run, Counted::lap, Counted::dead_end};
constexpr std::string_view gate_to_gate = "gate to gate", rest_to_centre = "rest to centre";

std::string range_of(const RulesNumber& number) {
  return fmt::format("a {} from {:g} to {:g}", number.whole ? "whole number" : "number of seconds", number.low,
                     number.high);
}

/// Reads values from a table and collects its problems.
class RulesReader {
 public:
  explicit RulesReader(const toml::table& table) : table_(table) {
    for (const auto& [key, value] : table)
      if (std::find(rule_keys.begin(), rule_keys.end(), key.str()) == rule_keys.end())
        add(key.source().begin, unknown_key(std::string(key.str()), rule_keys));
  }

  /// The number of a key; 0 where it is missing or wrong.
  double number(const RulesNumber& key) {
    const toml::node* node = table_.get(key.name);
    if (node == nullptr) {
      if (key.needed) add({0, 0}, fmt::format("missing key '{}': {}", key.name, range_of(key)));
      return 0.0;
    }
    const double value = node->value<double>().value_or(std::nan(""));
    if (node->is_number() && value >= key.low && value <= key.high && (!key.whole || node->is_integer())) return value;
    add(node->source().begin, fmt::format("'{}' must be {}", key.name, range_of(key)));
    return 0.0;
  }

  /// The text of a required key, which must not be empty.
  std::string text(std::string_view key, std::string_view meaning) {
    const toml::node* node = table_.get(key);
    if (node == nullptr) {
      add({0, 0}, fmt::format("missing key '{}': {}", key, meaning));
      return "";
    }
    std::string value = node->value<std::string>().value_or("");
    if (value.empty()) add(node->source().begin, fmt::format("'{}' must be {}", key, meaning));
    return value;
  }

  /// "run" if the key is missing.
  Counted counts() {
    constexpr std::string_view meaning = "\"run\", \"lap\" or \"dead end\"";
    if (!table_.contains("counts")) return Counted::run;
    const std::string value = text("counts", meaning);
    for (const Counted counted : all_counted)
      if (value == name_of(counted)) return counted;
    if (!value.empty()) add(table_.get("counts")->source().begin, fmt::format("'counts' must be {}", meaning));
    return Counted::run;
  }

  /// The limit of runs or of laps; the key of the other one is refused.
  int limit(Counted counts) {
    const bool lap = counts == Counted::lap;
    const RulesNumber &key = lap ? laps : runs, &other = lap ? runs : laps;
    refuse(other, counts, fmt::format("; give '{}'", key.name));
    return static_cast<int>(number(key));
  }

  /// A number that only goes with some of what rules can count; 0 with the others, where its key is refused.
  double number_if(bool goes, const RulesNumber& key, Counted counts) {
    if (goes) return number(key);
    refuse(key, counts, "");
    return 0.0;
  }

  bool clock(Counted counts) {
    constexpr std::string_view meaning = "\"gate to gate\" or \"rest to centre\"";
    const std::string value = text("clock", meaning);
    if (!value.empty() && value != gate_to_gate && value != rest_to_centre)
      add(table_.get("clock")->source().begin, fmt::format("'clock' must be {}", meaning));
    if (value == rest_to_centre && counts != Counted::run)
      add(table_.get("clock")->source().begin,
          fmt::format("'clock' must be \"gate to gate\" with counts = \"{}\"", name_of(counts)));
    return value == gate_to_gate;
  }

  std::vector<Problem> problems() const { return in_order(problems_); }

 private:
  void refuse(const RulesNumber& key, Counted counts, const std::string& instead) {
    if (const toml::node* node = table_.get(key.name))
      add(node->source().begin,
          fmt::format("'{}' does not go with counts = \"{}\"{}", key.name, name_of(counts), instead));
  }

  void add(const toml::source_position& place, std::string reason) {
    problems_.push_back(problem_at(place, std::move(reason)));
  }

  const toml::table& table_;
  std::vector<Problem> problems_;
};

std::int64_t whole_microseconds(double seconds) { return static_cast<std::int64_t>(std::floor(seconds * 1e6 + 0.5)); }

}  // namespace

DriveRulesResult read_drive_rules(std::string_view text, std::string_view name) {
  const TomlText toml = parse_toml(text);
  if (!toml.problems.empty()) return {std::nullopt, toml.problems};
  RulesReader reader(toml.table);
  DriveRules rules;
  rules.name = name;
  rules.source = shown(reader.text("source", "where and when the rules apply, in words"));
  rules.time_limit = whole_microseconds(reader.number(time_limit));
  rules.counts = reader.counts();
  rules.most_runs = reader.limit(rules.counts);
  const bool in_marks = rules.counts == Counted::dead_end;
  if (const double full = reader.number_if(in_marks, marks, rules.counts); in_marks)
    rules.marks = static_cast<int>(full);
  const auto in_time = [&](const RulesNumber& key) { return reader.number_if(!in_marks, key, rules.counts); };
  rules.maze_time_divisor = static_cast<int>(in_time(maze_time_divisor));
  rules.touch_penalty = whole_microseconds(in_time(touch_penalty));
  rules.untouched_bonus = whole_microseconds(in_time(untouched_bonus));
  rules.gate_to_gate = reader.clock(rules.counts);
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
