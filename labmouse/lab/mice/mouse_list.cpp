#include "labmouse/lab/mice/mouse_list.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/mouse/tie_order.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {
namespace {

constexpr std::string_view oracle_summary = "knows the maze; attains the bound, and is not a contestant";

std::string range_of(const Parameter& parameter) {
  switch (parameter.type) {
    case ParameterType::flag:
      return "yes or no";
    case ParameterType::choice:
      // There are too many tie-breaking orders to list.
      return parameter.choices == TieOrder::all ? "an order such as nesw or alrb" : std::string(parameter.choices);
    case ParameterType::prior:
      return fmt::format("{} or a file of `labmouse learn`", parameter.choices);
    default:
      return fmt::format("{:g} to {:g}", parameter.low, parameter.high);
  }
}

std::string value_line(const Parameter& parameter) {
  return fmt::format("    {}={}  {}, {}\n", parameter.name, parameter.default_value, name_of(parameter.type),
                     range_of(parameter));
}

/// The heading of parameters that count in the same worlds. It does not name the world of a mouse that races in one
/// kind of world only.
std::string_view heading_of(const Parameter& parameter, const BuiltinMouse& mouse) {
  if (parameter.scope == ParameterScope::errors) return "Parameters, only in worlds with errors";
  if (!mouse.walks() || !mouse.drives() || parameter.scope == ParameterScope::both) return "Parameters";
  return parameter.scope == ParameterScope::seconds ? "Parameters, only in seconds" : "Parameters, only in steps";
}

std::string summary_of(const BuiltinMouse& mouse) {
  return fmt::format("{}{}", mouse.summary, mouse.uses_chance(Settings(mouse.parameters)) ? " (stochastic)" : "");
}

/// The text wrapped into indented lines.
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

/// All parameters with their meanings, grouped by the worlds in which they count.
std::string explained_parameters(const BuiltinMouse& mouse) {
  std::string text;
  std::string_view heading;
  for (const Parameter& parameter : mouse.parameters) {
    if (const auto next = heading_of(parameter, mouse); next != heading) {
      text += fmt::format("{}{}\n", text.empty() ? "" : "\n", next);
      heading = next;
    }
    text += value_line(parameter) + in_lines(parameter.meaning, "        ");
  }
  return text.empty() ? "Parameters\n    none\n" : text;
}

}  // namespace

std::string mouse_list() {
  std::size_t width = 0;
  for (const BuiltinMouse* mouse : all_mice()) width = std::max(width, mouse->name.size());
  std::string text;
  for (const BuiltinMouse* mouse : all_mice()) {
    text += fmt::format("{:<{}}  {}\n", mouse->name, width, summary_of(*mouse));
    for (const Parameter& parameter : mouse->parameters) text += value_line(parameter);
  }
  return text + fmt::format("{:<{}}  {}\n\n`labmouse mice NAME` explains a mouse and its parameters.\n", "oracle",
                            width, oracle_summary);
}

NamedText mouse_sheet(const std::string& name) {
  if (name == "oracle") return {fmt::format("oracle: {}\n", oracle_summary), ""};
  const BuiltinMouse* mouse = find_mouse(name);
  if (mouse == nullptr) return {"", "error: " + unknown_mouse(name)};
  return {fmt::format("{}: {}\n\nMethod\n{}\n{}\nSource\n{}", mouse->name, summary_of(*mouse),
                      in_lines(mouse->method, "    "), explained_parameters(*mouse), in_lines(mouse->source, "    ")) +
              (mouse->drives() ? "\nIt also drives, in seconds.\n" : ""),
          ""};
}

}  // namespace labmouse
