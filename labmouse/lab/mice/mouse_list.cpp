#include "labmouse/lab/mice/mouse_list.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/mouse/tie_order.hpp"
#include "labmouse/strategies/roster.hpp"

namespace labmouse {
namespace {

constexpr std::string_view oracle_summary = "knows the maze; attains the bound, and is not a contestant";

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

/// In front of the meaning of what counts in some worlds in seconds alone.
std::string_view scope_text(ParameterScope scope) {
  if (scope == ParameterScope::errors) return "where things go wrong: ";
  return scope == ParameterScope::seconds ? "in seconds: " : "";
}

std::string parameter_lines(const RosterEntry& mouse) {
  std::string text;
  for (const Parameter& parameter : mouse.parameters)
    text += fmt::format("    {}={}  {}, {}: {}{}\n", parameter.name, parameter.default_value, name_of(parameter.type),
                        range_of(parameter),
                        mouse.walks() || parameter.scope == ParameterScope::errors ? scope_text(parameter.scope) : "",
                        parameter.meaning);
  return text;
}

std::string summary_of(const RosterEntry& mouse) {
  return fmt::format("{}{}", mouse.summary, mouse.uses_chance(Settings(mouse.parameters)) ? " (stochastic)" : "");
}

/// The text in lines of a width that is easy to read, each after the indent.
std::string in_lines(std::string_view text, std::string_view indent) {
  constexpr std::size_t width = 96;
  std::string lines;
  while (!text.empty()) {
    auto end = text.size() > width ? text.rfind(' ', width) : text.size();
    if (end == std::string_view::npos) end = text.size();
    lines += fmt::format("{}{}\n", indent, text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

}  // namespace

std::string mouse_list() {
  std::size_t width = 0;
  for (const RosterEntry* mouse : all_mice()) width = std::max(width, mouse->name.size());
  std::string text;
  for (const RosterEntry* mouse : all_mice())
    text += fmt::format("{:<{}}  {}\n{}", mouse->name, width, summary_of(*mouse), parameter_lines(*mouse));
  return text + fmt::format("{:<{}}  {}\n", "oracle", width, oracle_summary);
}

NamedText mouse_sheet(const std::string& name) {
  if (name == "oracle") return {fmt::format("oracle: {}\n", oracle_summary), ""};
  const RosterEntry* mouse = find_mouse(name);
  if (mouse == nullptr) return {"", "error: " + unknown_mouse(name)};
  const std::string parameters = parameter_lines(*mouse);
  return {fmt::format("{}: {}\n\nMethod\n{}\nParameters\n{}\nSource\n{}", mouse->name, summary_of(*mouse),
                      in_lines(mouse->method, "    "), parameters.empty() ? "    none\n" : parameters,
                      in_lines(mouse->source, "    ")) +
              (mouse->drives() ? "\nIt also drives, in seconds.\n" : ""),
          ""};
}

}  // namespace labmouse
