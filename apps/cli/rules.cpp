// labmouse rules: the rules of contests in seconds.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "command.hpp"
#include "labmouse/lab/drive/drive_results.hpp"
#include "labmouse/lab/robots/builtin_rules.hpp"
#include "labmouse/lab/robots/drive_rules_file.hpp"
#include "labmouse/lab/system/files.hpp"

namespace labmouse::cli {
namespace {

/// The text of the rules file, with its comments. Those of the built-in rules say which numbers are certain.
std::string text_of_rules(const std::string& name) {
  for (const BuiltinRules& rules : builtin_rules())
    if (rules.name == name) return std::string(rules.text);
  return read_file(name).content;
}

void show(const std::string& name) {
  const DriveRules rules = find_rules_or_refuse(name);
  print(fmt::format("{}\n# {}: {}.\n", text_of_rules(name), name, formula_of(rules)));
}

void list_rules() {
  std::size_t width = 0;
  for (const BuiltinRules& rules : builtin_rules()) width = std::max(width, rules.name.size());
  std::string text;
  for (const BuiltinRules& rules : builtin_rules())
    text += fmt::format("{:<{}}  {}\n", rules.name, width, formula_of(find_rules_or_refuse(std::string(rules.name))));
  print(text);
}

}  // namespace

DriveRules find_rules_or_refuse(const std::string& name) {
  FoundRules found = find_rules(name);
  if (!found.errors.empty()) throw UsageError(fmt::format("{}", fmt::join(found.errors, "\n")));
  return std::move(found.rules);
}

void add_rules(Command& app, int& exit) {
  Command* command = app.add_subcommand("rules", "Show the rules of contests in seconds");
  command->require_subcommand();
  command->footer("Example: labmouse rules show thirtieth > mine.toml");

  auto name = std::make_shared<std::string>("all-japan");
  Command* shown = command->add_subcommand("show", "Print a rules file, as a starting point for your own");
  shown->add_option("rules", *name, "Built-in rules, or a file whose name contains a slash or ends in .toml")
      ->type_name("RULES")
      ->capture_default_str();
  shown->footer("Example: labmouse rules show thirtieth > mine.toml");
  shown->callback([name, &exit] {
    show(*name);
    exit = exit_good;
  });

  Command* listed = command->add_subcommand("list", "List the built-in rules");
  listed->footer("Example: labmouse rules list");
  listed->callback([&exit] {
    list_rules();
    exit = exit_good;
  });
}

}  // namespace labmouse::cli
