// labmouse mice: the roster.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "labmouse/mouse/tie_order.hpp"
#include "labmouse/strategies/roster.hpp"

namespace labmouse::cli {
namespace {

std::string range_of(const Parameter& parameter) {
  switch (parameter.type) {
    case ParameterType::flag: return "yes or no";
    case ParameterType::choice:
      // Orders to break ties by are too many to read.
      return parameter.choices == TieOrder::all ? "an order such as nesw or alrb" : std::string(parameter.choices);
    case ParameterType::prior: return fmt::format("{} or a file of `labmouse learn`", parameter.choices);
    default: return fmt::format("{:g} to {:g}", parameter.low, parameter.high);
  }
}

std::string describe_mice() {
  std::size_t width = 0;
  for (const RosterEntry* mouse : roster()) width = std::max(width, mouse->name.size());
  std::string text;
  for (const RosterEntry* mouse : roster()) {
    text += fmt::format("{:<{}}  {}{}\n", mouse->name, width, mouse->summary, mouse->uses_chance(Settings(mouse->parameters)) ? " (throws dice)" : "");
    for (const Parameter& parameter : mouse->parameters)
      text += fmt::format("    {}={}  {}, {}: {}\n", parameter.name, parameter.default_value, name_of(parameter.type),
                          range_of(parameter), parameter.meaning);
  }
  return text + fmt::format("{:<{}}  {}\n", "oracle", width, "knows the maze: the bound's witness, not a contestant");
}

nlohmann::ordered_json describe(const Parameter& parameter) {
  nlohmann::ordered_json json = {{"name", parameter.name},
                                 {"type", name_of(parameter.type)},
                                 {"default", parameter.default_value},
                                 {"meaning", parameter.meaning}};
  switch (parameter.type) {
    case ParameterType::flag: break;
    case ParameterType::choice:
    case ParameterType::prior: json["choices"] = choices_of(parameter); break;
    default: json["low"] = parameter.low, json["high"] = parameter.high;
  }
  return json;
}

std::string mice_json() {
  auto mice = nlohmann::ordered_json::array();
  for (const RosterEntry* mouse : roster()) {
    auto parameters = nlohmann::ordered_json::array();
    for (const Parameter& parameter : mouse->parameters) parameters.push_back(describe(parameter));
    mice.push_back({{"name", mouse->name},
                    {"summary", mouse->summary},
                    {"throws_dice", mouse->uses_chance(Settings(mouse->parameters))},
                    {"parameters", std::move(parameters)}});
  }
  return mice.dump(1) + "\n";
}

}  // namespace

void add_mice(CLI::App& app, int& exit) {
  auto format = std::make_shared<std::string>("table");
  CLI::App* command = app.add_subcommand("mice", "List the mice and their parameters with defaults and ranges");
  command->add_option("--format", *format, "Output")->check(CLI::IsMember({"table", "json"}))->capture_default_str();
  command->footer("Example: labmouse mice --format json");
  command->callback([format, &exit] {
    print(*format == "json" ? mice_json() : describe_mice());
    exit = exit_good;
  });
}

}  // namespace labmouse::cli
