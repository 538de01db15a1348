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

/// Sets of what rules can count.
constexpr unsigned bit_of(Counted counted) { return 1U << static_cast<unsigned>(counted); }
constexpr unsigned with_runs = bit_of(Counted::run), with_laps = bit_of(Counted::lap),
                   with_dead_ends = bit_of(Counted::dead_end);

/// A number in a file of rules; times are in seconds.
struct RulesNumber {
  std::string_view name;
  unsigned with = 0;  ///< what rules must count for it to have a meaning
  double low = 0.0;
  double high = 0.0;
  bool whole = false;
  bool needed = false;
};

constexpr unsigned with_time = with_runs | with_laps, with_all = with_time | with_dead_ends;
constexpr RulesNumber time_limit = {.name = "time_limit", .with = with_all, .low = 1, .high = 7200, .needed = true};
constexpr RulesNumber runs = {
    .name = "runs", .with = with_runs | with_dead_ends, .low = 1, .high = 100, .whole = true, .needed = true};
constexpr RulesNumber laps = {.name = "laps", .with = with_laps, .low = 1, .high = 20, .whole = true, .needed = true};
constexpr RulesNumber marks = {
    .name = "marks", .with = with_dead_ends, .low = 1, .high = most_marks, .whole = true, .needed = true};
constexpr RulesNumber maze_time_divisor = {
    .name = "maze_time_divisor", .with = with_time, .low = 1, .high = 1000, .whole = true};
constexpr RulesNumber touch_penalty = {.name = "touch_penalty", .with = with_time, .high = 600};
constexpr RulesNumber untouched_bonus = {.name = "untouched_bonus", .with = with_time, .high = 600};

constexpr std::array<std::string_view, 10> rule_keys = {
    "source",        "time_limit",      "counts", "runs", "laps", "marks", "maze_time_divisor",
    "touch_penalty", "untouched_bonus", "clock"};
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
    read_counts();
  }

  /// What the rules count: "run" if the key is missing; nothing if it is wrong, and then no key is refused for it.
  std::optional<Counted> counts() const { return counts_; }

  /// The number of a key; 0 where it is missing, wrong, or does not go with what the rules count.
  double number(const RulesNumber& key) {
    const toml::node* node = table_.get(key.name);
    if (!counts_) return 0.0;
    if ((key.with & bit_of(*counts_)) == 0) {
      if (node != nullptr)
        add(node->source().begin,
            fmt::format("'{}' does not go with counts = \"{}\"; remove it", key.name, name_of(*counts_)));
      return 0.0;
    }
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

  int whole(const RulesNumber& key) { return static_cast<int>(number(key)); }
  std::int64_t microseconds(const RulesNumber& key) {
    return static_cast<std::int64_t>(std::floor(number(key) * 1e6 + 0.5));
  }

  bool clock() {
    constexpr std::string_view meaning = "\"gate to gate\" or \"rest to centre\"";
    const std::string value = text("clock", meaning);
    if (!value.empty() && value != gate_to_gate && value != rest_to_centre)
      add(table_.get("clock")->source().begin, fmt::format("'clock' must be {}", meaning));
    if (value == rest_to_centre && counts_ && *counts_ != Counted::run)
      add(table_.get("clock")->source().begin,
          fmt::format("'clock' must be \"gate to gate\" with counts = \"{}\"", name_of(*counts_)));
    return value == gate_to_gate;
  }

  std::vector<Problem> problems() const { return in_order(problems_); }

 private:
  void read_counts() {
    constexpr std::string_view meaning = "\"run\", \"lap\" or \"dead end\"";
    if (!table_.contains("counts")) return;
    const std::string value = text("counts", meaning);
    counts_ = counted_named(value);
    if (!counts_ && !value.empty())
      add(table_.get("counts")->source().begin, fmt::format("'counts' must be {}", meaning));
  }

  void add(const toml::source_position& place, std::string reason) {
    problems_.push_back(problem_at(place, std::move(reason)));
  }

  const toml::table& table_;
  std::optional<Counted> counts_ = Counted::run;
  std::vector<Problem> problems_;
};

}  // namespace

DriveRulesResult read_drive_rules(std::string_view text, std::string_view name) {
  const TomlText toml = parse_toml(text);
  if (!toml.problems.empty()) return {std::nullopt, toml.problems};
  RulesReader reader(toml.table);
  DriveRules rules;
  rules.name = name;
  rules.source = shown(reader.text("source", "where and when the rules apply, in words"));
  rules.time_limit = reader.microseconds(time_limit);
  rules.counts = reader.counts().value_or(Counted::run);
  rules.most_runs = reader.whole(runs) + reader.whole(laps);  // one of the two goes with what counts
  rules.marks = reader.whole(marks);
  rules.maze_time_divisor = reader.whole(maze_time_divisor);
  rules.touch_penalty = reader.microseconds(touch_penalty);
  rules.untouched_bonus = reader.microseconds(untouched_bonus);
  rules.gate_to_gate = reader.clock();
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
