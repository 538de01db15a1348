#include "labmouse/lab/mice_files/mice_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "labmouse/lab/text/former_names.hpp"
#include "labmouse/lab/text/parts_spec.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/lab/text/toml_text.hpp"

namespace labmouse {
namespace {

using Kind = MiceFileEntry::Kind;

constexpr std::array<Kind, 5> all_kinds = {Kind::mouse, Kind::capstone, Kind::external, Kind::controller, Kind::mms};
constexpr std::array<std::string_view, 13> mouse_keys = {"name", "mouse",     "capstone",    "program",   "controller",
                                                         "mms",  "arguments", "environment", "directory", "interpreter",
                                                         "runs", "limits",    "note"};
constexpr std::array<std::string_view, 8> limit_keys = {"start",  "decision",  "silence", "contest",
                                                        "memory", "processes", "written", "cpu"};

/// Reads the entries of a mice file, and collects its problems.
class MiceFileReader {
 public:
  MiceFileResult read(const toml::table& file) {
    for (const auto& [key, value] : file)
      if (key.str() != "mouse") add(key, unknown_key(std::string(key.str()), std::array{std::string_view("mouse")}));
    const toml::array* mice = file["mouse"].as_array();
    if (mice == nullptr || mice->empty() || !mice->is_homogeneous<toml::table>()) {
      if (problems_.empty()) problems_.push_back({1, 1, "has no mice; each begins with a line [[mouse]]"});
      return {{}, in_order(problems_)};
    }
    MiceFileResult result;
    for (const toml::node& mouse : *mice) result.mice.push_back(mouse_of(*mouse.as_table()));
    if (!problems_.empty()) return {{}, in_order(problems_)};
    return result;
  }

 private:
  void add(const toml::key& key, std::string reason) { add(key.source().begin, std::move(reason)); }
  void add(const toml::source_position& place, std::string reason) {
    problems_.push_back(problem_at(place, std::move(reason)));
  }

  void refuse_unknown(const toml::table& table, std::span<const std::string_view> known) {
    for (const auto& [key, value] : table)
      if (std::find(known.begin(), known.end(), today_key(key.str())) == known.end())
        add(key, unknown_key(std::string(key.str()), known));
  }

  MiceFileEntry mouse_of(const toml::table& table) {
    MiceFileEntry mouse;
    const auto place = table.source().begin;
    mouse.line = static_cast<int>(place.line);
    mouse.column = static_cast<int>(place.column);
    refuse_unknown(table, mouse_keys);
    read_name(table, mouse);
    read_kind(table, mouse);
    mouse.arguments = texts(table, "arguments");
    mouse.environment = variables(table);
    mouse.directory = text(table, "directory");
    mouse.interpreter = text(table, "interpreter");
    mouse.note = text(table, "note");
    mouse.runs = whole(table, "runs", 1, 1'000'000);
    read_limits(table, mouse);
    if (table.contains("mouse") && parts_place(mouse.what) == std::string::npos) refuse_for_ours(table);
    if (mouse.kind == Kind::capstone)
      refuse(table, "directory", "has no effect: a robot runs in the folder of its file");
    return mouse;
  }

  void read_name(const toml::table& table, MiceFileEntry& mouse) {
    mouse.name = text(table, "name");
    const toml::node* node = table.get("name");
    if (node == nullptr)
      add(table.source().begin, "this mouse has no name; add name = \"...\"");
    else if (!mouse.name.empty() && !names_.insert(mouse.name).second)
      add(node->source().begin, fmt::format("the name '{}' stands twice; give each mouse its own", mouse.name));
  }

  void read_kind(const toml::table& table, MiceFileEntry& mouse) {
    int kinds = 0;
    for (const Kind kind : all_kinds) {
      const std::string_view key = table.contains(key_of(kind)) ? key_of(kind) : former_key(key_of(kind));
      const toml::node* node = table.get(key);
      if (node == nullptr) continue;
      if (++kinds == 2)
        add(node->source().begin,
            fmt::format("a mouse is one of mouse, capstone, program, controller and mms; this is '{}' already",
                        key_of(mouse.kind)));
      if (kinds > 1) continue;
      mouse.kind = kind;
      mouse.what = text(table, key);
    }
    if (kinds == 0)
      add(table.source().begin,
          "this mouse says neither mouse = \"SPEC\" nor capstone = \"FILE\" nor program, controller or mms = "
          "\"COMMAND\"");
  }

  /// Refuses keys that have no effect for a built-in mouse without external parts, which runs within this program.
  void refuse_for_ours(const toml::table& table) {
    for (const std::string_view key : {"arguments", "environment", "directory", "interpreter", "limits"})
      refuse(table, key, "is for external mice; labmouse's own mice do not have it");
  }

  void refuse(const toml::table& table, std::string_view key, std::string_view reason) {
    if (const toml::node* node = table.get(key)) add(node->source().begin, fmt::format("'{}' {}", key, reason));
  }

  void read_limits(const toml::table& table, MiceFileEntry& mouse) {
    const toml::node* node = table.get("limits");
    if (node == nullptr) return;
    const toml::table* limits = node->as_table();
    if (limits == nullptr) return add(node->source().begin, "'limits' must be a table, such as { contest = 120 }");
    refuse_unknown(*limits, limit_keys);
    constexpr double most_seconds = 1e6;
    constexpr int most_mib = 1 << 20, least_mib = 16, most_processes = 4096;
    mouse.start = seconds(*limits, "start", most_seconds);
    mouse.decision = seconds(*limits, "decision", most_seconds);
    mouse.silence = seconds(*limits, "silence", most_seconds);
    mouse.contest = seconds(*limits, "contest", most_seconds);
    mouse.memory = whole(*limits, "memory", least_mib, most_mib);
    mouse.written = whole(*limits, "written", least_mib, most_mib);
    mouse.processes = whole(*limits, "processes", 1, most_processes);
    mouse.processor_seconds = whole(*limits, "cpu", 1, static_cast<int>(most_seconds));
  }

  /// The text of a key, which must be printable and not empty; an empty text if the key is missing.
  std::string text(const toml::table& table, std::string_view key) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return "";
    std::string value = node->value<std::string>().value_or("");
    if (value.empty() || shown(value) != value)
      add(node->source().begin, fmt::format("'{}' must be a text in quotation marks, printable and not empty", key));
    return value;
  }

  std::vector<std::string> texts(const toml::table& table, std::string_view key) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return {};
    const toml::array* array = node->as_array();
    std::vector<std::string> values;
    const auto is_text = [](const toml::node& each) {
      const auto value = each.value<std::string>();
      return each.is_string() && value->find('\0') == std::string::npos;
    };
    if (array == nullptr || !std::all_of(array->begin(), array->end(), is_text)) {
      add(node->source().begin, fmt::format("'{}' must be a list of texts, such as [\"fast\", \"no\"]", key));
      return {};
    }
    for (const toml::node& each : *array) values.push_back(*each.value<std::string>());
    return values;
  }

  std::vector<std::string> variables(const toml::table& table) {
    const toml::node* node = table.get("environment");
    if (node == nullptr) return {};
    const toml::table* variables = node->as_table();
    std::vector<std::string> all;
    if (variables == nullptr) {
      add(node->source().begin, "'environment' must be a table, such as { MODE = \"fast\" }");
      return {};
    }
    for (const auto& [key, value] : *variables) {
      const auto name = std::string(key.str());
      const auto text = value.value<std::string>().value_or("\n");
      if (!value.is_string() || (name + text).find('\0') != std::string::npos || name.empty() ||
          name.find('=') != std::string::npos)
        add(value.source().begin, fmt::format("the variable {} must be a text in quotation marks", shown(name)));
      all.push_back(fmt::format("{}={}", name, text));
    }
    return all;
  }

  std::optional<int> whole(const toml::table& table, std::string_view key, int low, int high) {
    const toml::node* node = table.get(key);
    if (node == nullptr) return std::nullopt;
    const auto value = node->value<std::int64_t>();
    if (node->is_integer() && *value >= low && *value <= high) return static_cast<int>(*value);
    add(node->source().begin, fmt::format("'{}' must be a whole number from {} to {}", key, low, high));
    return std::nullopt;
  }

  std::optional<double> seconds(const toml::table& table, std::string_view key, double high) {
    constexpr double low = 0.001;
    const toml::node* node = table.get(key);
    if (node == nullptr) return std::nullopt;
    const double value = node->value<double>().value_or(std::nan(""));
    if (node->is_number() && value >= low && value <= high) return value;
    add(node->source().begin, fmt::format("'{}' must be a number of seconds from {:g} to {:g}", key, low, high));
    return std::nullopt;
  }

  std::set<std::string> names_;
  std::vector<Problem> problems_;
};

void set_seconds(const std::optional<double>& seconds, std::chrono::milliseconds& limit) {
  constexpr double milliseconds = 1000.0;
  if (seconds) limit = std::chrono::milliseconds(std::llround(milliseconds * *seconds));
}

void set_mebibytes(const std::optional<int>& mib, std::uint64_t& limit) {
  constexpr int mib_bits = 20;
  if (mib) limit = static_cast<std::uint64_t>(*mib) << mib_bits;
}

}  // namespace

std::string_view key_of(MiceFileEntry::Kind kind) {
  constexpr std::array<std::string_view, 5> keys = {"mouse", "capstone", "program", "controller", "mms"};
  return keys[static_cast<std::size_t>(kind)];
}

ExternalLimits MiceFileEntry::limits_over(ExternalLimits limits) const {
  set_seconds(start, limits.start);
  set_seconds(decision, limits.decision);
  set_seconds(silence, limits.silence);
  set_seconds(contest, limits.contest);
  set_mebibytes(memory, limits.memory);
  set_mebibytes(written, limits.written);
  limits.processes = processes.value_or(limits.processes);
  limits.processor_seconds = processor_seconds.value_or(limits.processor_seconds);
  return limits;
}

MiceFileResult read_mice_file(std::string_view text) {
  const TomlText toml = parse_toml(text);
  if (!toml.problems.empty()) return {{}, toml.problems};
  return MiceFileReader().read(toml.table);
}

}  // namespace labmouse
