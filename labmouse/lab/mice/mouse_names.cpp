#include "labmouse/lab/mice/mouse_names.hpp"

#include <set>

#include "labmouse/lab/mice/external_specs.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// Without `mms:`: mice of mms have a table of their own.
std::string_view without_world(std::string_view spec) {
  constexpr std::string_view mms = "mms:";
  return spec.starts_with(mms) ? spec.substr(mms.size()) : spec;
}

std::string short_name(const std::string& spec, std::size_t most) {
  const std::u32string letters = printable(without_world(spec));
  if (!is_external_spec(spec) || letters.size() <= most) return utf8(letters);
  return "..." + utf8(letters.substr(letters.size() - most + 3));
}

}  // namespace

std::vector<std::string> mouse_names(const std::vector<std::string>& specs) {
  std::vector<std::string> names;
  for (const std::size_t most : {std::size_t{32}, std::size_t{60}, std::string::npos}) {
    names.clear();
    for (const std::string& spec : specs) names.push_back(short_name(spec, most));
    if (std::set<std::string>(names.begin(), names.end()).size() == names.size()) break;
  }
  return names;
}

}  // namespace labmouse
