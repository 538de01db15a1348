#include "labmouse/lab/page/mouse_spec.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/mice/external_specs.hpp"
#include "labmouse/lab/mice/named_spec.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {
namespace {

/// Removes and returns the text up to a separator; removes the separator, too.
std::string_view next_piece(std::string_view& text, char separator) {
  const auto length = std::min(text.find(separator), text.size());
  const auto piece = text.substr(0, length);
  text.remove_prefix(std::min(length + 1, text.size()));
  return piece;
}

/// An error if `key=value` of a mouse names a file; else empty.
std::string needs_file(const BuiltinMouse& mouse, std::string_view assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string_view::npos) return "";
  const auto key = assignment.substr(0, equals), value = assignment.substr(equals + 1);
  for (const Parameter& parameter : mouse.parameters) {
    if (parameter.name != key || parameter.type != ParameterType::prior) continue;
    const auto choices = choices_of(parameter);
    if (std::find(choices.begin(), choices.end(), value) == choices.end())
      return fmt::format("prior '{}' of mouse '{}' is a file, which the page cannot read; it has {}", value, mouse.name,
                         fmt::join(choices, ", "));
  }
  return "";
}

std::string refused(std::string_view text) {
  while (!text.empty()) {
    const std::string_view spec = named_spec(text).spec;
    if (is_mice_file_spec(spec)) return fmt::format("mice file '{}' is a file, which the page cannot read", spec);
    if (is_external_spec(spec))
      return fmt::format("mouse '{}' is a program, which the page cannot start; use `labmouse race`", spec);
    text = spec;
    std::string_view mouse = next_piece(text, ',');
    const BuiltinMouse* entry = find_mouse(next_piece(mouse, ':'));
    while (entry != nullptr && !mouse.empty())
      if (auto reason = needs_file(*entry, next_piece(mouse, ':')); !reason.empty()) return reason;
  }
  return "";
}

}  // namespace

SpecResult read_page_mice(std::span<const std::string> specs) {
  for (const std::string& spec : specs)
    if (auto reason = refused(spec); !reason.empty()) return {{}, std::move(reason)};
  return read_specs(specs);
}

}  // namespace labmouse
