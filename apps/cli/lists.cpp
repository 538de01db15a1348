// labmouse mice: the roster.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "command.hpp"
#include "labmouse/lab/mice/mice_json.hpp"
#include "labmouse/mouse/tie_order.hpp"
#include "labmouse/strategies/roster.hpp"

namespace labmouse::cli {
namespace {

std::string range_of(const Parameter& parameter) {
  switch (parameter.type) {
    case ParameterType::flag:
      return "yes or no";
    case ParameterType::choice:
      // Orders to break ties by are too many to read.
      return parameter.choices == TieOrder::all ? "an order such as nesw or alrb" : std::string(parameter.choices);
    case ParameterType::prior:
      return fmt::format("{} or a file of `labmouse learn`", parameter.choices);
    default:
      return fmt::format("{:g} to {:g}", parameter.low, parameter.high);
  }
}

std::string describe_mice() {
  std::size_t width = 0;
  for (const RosterEntry* mouse : roster()) width = std::max(width, mouse->name.size());
  std::string text;
  for (const RosterEntry* mouse : roster()) {
    text += fmt::format("{:<{}}  {}{}\n", mouse->name, width, mouse->summary,
                        mouse->uses_chance(Settings(mouse->parameters)) ? " (throws dice)" : "");
    for (const Parameter& parameter : mouse->parameters)
      text += fmt::format("    {}={}  {}, {}: {}\n", parameter.name, parameter.default_value, name_of(parameter.type),
                          range_of(parameter), parameter.meaning);
  }
  return text + fmt::format("{:<{}}  {}\n", "oracle", width, "knows the maze: the bound's witness, not a contestant");
}

}  // namespace

void add_mice(Command& app, int& exit) {
  auto format = std::make_shared<std::string>("table");
  Command* command = app.add_subcommand("mice", "List the mice and their parameters with defaults and ranges");
  command->add_option("--format", *format, "Output")->check(one_of({"table", "json"}))->capture_default_str();
  command->footer("Example: labmouse mice --format json");
  command->callback([format, &exit] {
    print(*format == "json" ? mice_json().dump(1) + "\n" : describe_mice());
    exit = exit_good;
  });
}

}  // namespace labmouse::cli
