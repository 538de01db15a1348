// labmouse mice: the list of built-in mice.
#include <memory>

#include "command.hpp"
#include "labmouse/lab/mice/mice_json.hpp"
#include "labmouse/lab/mice/mouse_list.hpp"
#include "labmouse/lab/mice/specs.hpp"

namespace labmouse::cli {
namespace {

std::string sheet_of(const std::string& name) {
  const NamedText sheet = mouse_sheet(name);
  if (!sheet.error.empty()) throw UsageError(sheet.error);
  return sheet.text;
}

std::string json_of(const std::string& name) {
  Json mice = mice_json();
  if (name.empty()) return mice.dump(1) + "\n";
  for (Json& mouse : mice)
    if (mouse["name"] == name) return mouse.dump(1) + "\n";
  throw UsageError("error: " + unknown_mouse(name));
}

}  // namespace

void add_mice(Command& app, int& exit) {
  auto name = std::make_shared<std::string>();
  auto format = std::make_shared<std::string>("table");
  Command* command = app.add_subcommand("mice", "List the mice with their parameters, defaults and ranges");
  command->add_option("name", *name, "Show only this mouse, with its method and source")->type_name("NAME");
  command->add_option("--format", *format, "What is printed")->check(one_of({"table", "json"}))->capture_default_str();
  command->footer("Example: labmouse mice ariadne\n         labmouse mice --format json");
  command->callback([name, format, &exit] {
    print(*format == "json" ? json_of(*name) : name->empty() ? mouse_list() : sheet_of(*name));
    exit = exit_good;
  });
}

}  // namespace labmouse::cli
