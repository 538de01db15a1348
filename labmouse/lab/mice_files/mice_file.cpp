#include "labmouse/lab/mice_files/mice_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "labmouse/lab/mice_files/limit_table.hpp"
#include "labmouse/lab/text/former_names.hpp"
#include "labmouse/lab/text/parts_spec.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/lab/text/toml_fields.hpp"

namespace labmouse {
namespace {

using Kind = MiceFileEntry::Kind;

constexpr std::array<Kind, 6> all_kinds = {Kind::mouse,      Kind::capstone, Kind::external,
                                           Kind::controller, Kind::firmware, Kind::mms};
constexpr std::array<std::string_view, 4> file_keys = {"mouse", "authors", "licence", "robot"};
constexpr std::array<std::string_view, 14> mouse_keys = {
    "name",      "mouse",       "capstone",  "program",     "controller", "firmware", "mms",
    "arguments", "environment", "directory", "interpreter", "runs",       "limits",   "note"};

/// Reads the entries of a mice file, and collects its problems.
class MiceFileReader {
 public:
  MiceFileResult read(const toml::table& file) {
    fields_.refuse_unknown(file, file_keys);
    const toml::array* mice = file["mouse"].as_array();
    if (mice == nullptr || mice->empty() || !mice->is_homogeneous<toml::table>()) {
      if (fields_.good()) fields_.add({1, 1}, "has no mice; each begins with a line [[mouse]]");
      return {{}, fields_.problems()};
    }
    MiceFileResult result;
    result.authors = fields_.texts(file, "authors", "[\"Ada Lovelace\"]");
    result.licence = fields_.text(file, "licence");
    result.robot = fields_.text(file, "robot");
    for (const toml::node& mouse : *mice) result.mice.push_back(mouse_of(*mouse.as_table()));
    if (!fields_.good()) return {{}, fields_.problems()};
    return result;
  }

 private:
  MiceFileEntry mouse_of(const toml::table& table) {
    MiceFileEntry mouse;
    const auto place = table.source().begin;
    mouse.line = static_cast<int>(place.line);
    mouse.column = static_cast<int>(place.column);
    fields_.refuse_unknown(table, mouse_keys);
    read_name(table, mouse);
    read_kind(table, mouse);
    mouse.arguments = fields_.texts(table, "arguments", "[\"fast\", \"no\"]");
    mouse.environment = variables(table);
    mouse.directory = fields_.text(table, "directory");
    mouse.interpreter = fields_.text(table, "interpreter");
    mouse.note = fields_.text(table, "note");
    mouse.runs = fields_.whole(table, "runs", 1, 1'000'000);
    mouse.limits = read_limits(table, fields_);
    if (table.contains("mouse") && parts_place(mouse.what) == std::string::npos) refuse_for_ours(table);
    if (mouse.kind == Kind::capstone || mouse.kind == Kind::firmware)
      refuse(table, "directory", "has no effect: a robot or firmware runs in the folder of its file");
    return mouse;
  }

  void read_name(const toml::table& table, MiceFileEntry& mouse) {
    mouse.name = fields_.text(table, "name");
    const toml::node* node = table.get("name");
    if (node == nullptr)
      fields_.add(table.source().begin, "this mouse has no name; add name = \"...\"");
    else if (!mouse.name.empty() && !names_.insert(mouse.name).second)
      fields_.add(node->source().begin, fmt::format("the name '{}' stands twice; give each mouse its own", mouse.name));
  }

  void read_kind(const toml::table& table, MiceFileEntry& mouse) {
    int kinds = 0;
    for (const Kind kind : all_kinds) {
      const std::string_view key = table.contains(key_of(kind)) ? key_of(kind) : former_key(key_of(kind));
      const toml::node* node = table.get(key);
      if (node == nullptr) continue;
      if (++kinds == 2)
        fields_.add(
            node->source().begin,
            fmt::format(
                "a mouse is one of mouse, capstone, program, controller, firmware and mms; this is '{}' already",
                key_of(mouse.kind)));
      if (kinds > 1) continue;
      mouse.kind = kind;
      mouse.what = fields_.text(table, key);
    }
    if (kinds == 0)
      fields_.add(table.source().begin,
                  "this mouse says neither mouse = \"SPEC\" nor capstone or firmware = \"FILE\" nor program, "
                  "controller or mms = "
                  "\"COMMAND\"");
  }

  /// Refuses keys that have no effect for a built-in mouse without external parts, which runs within this program.
  void refuse_for_ours(const toml::table& table) {
    for (const std::string_view key : {"arguments", "environment", "directory", "interpreter", "limits"})
      refuse(table, key, "is for external mice; labmouse's own mice do not have it");
  }

  void refuse(const toml::table& table, std::string_view key, std::string_view reason) {
    if (const toml::node* node = table.get(key)) fields_.add(node->source().begin, fmt::format("'{}' {}", key, reason));
  }

  std::vector<std::string> variables(const toml::table& table) {
    const toml::node* node = table.get("environment");
    if (node == nullptr) return {};
    const toml::table* variables = node->as_table();
    std::vector<std::string> all;
    if (variables == nullptr) {
      fields_.add(node->source().begin, "'environment' must be a table, such as { MODE = \"fast\" }");
      return {};
    }
    for (const auto& [key, value] : *variables) {
      const auto name = std::string(key.str());
      const auto text = value.value<std::string>().value_or("\n");
      if (!value.is_string() || (name + text).find('\0') != std::string::npos || name.empty() ||
          name.find('=') != std::string::npos)
        fields_.add(value.source().begin,
                    fmt::format("the variable {} must be a text in quotation marks", shown(name)));
      all.push_back(fmt::format("{}={}", name, text));
    }
    return all;
  }

  std::set<std::string> names_;
  TomlFields fields_;
};

}  // namespace

std::string_view key_of(MiceFileEntry::Kind kind) {
  constexpr std::array<std::string_view, 6> keys = {"mouse", "capstone", "program", "controller", "firmware", "mms"};
  return keys[static_cast<std::size_t>(kind)];
}

MiceFileResult read_mice_file(std::string_view text) {
  const TomlText toml = parse_toml(text);
  if (!toml.problems.empty()) return {{}, toml.problems};
  return MiceFileReader().read(toml.table);
}

}  // namespace labmouse
