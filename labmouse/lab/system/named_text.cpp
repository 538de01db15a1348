#include "labmouse/lab/system/named_text.hpp"

#include <fmt/format.h>

#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

NamedText find_text(std::string_view kind, const std::vector<std::pair<std::string_view, std::string_view>>& builtins,
                    const std::string& name, std::string_view ending) {
  std::vector<std::string_view> names;
  for (const auto& [known, text] : builtins) {
    if (known == name) return {std::string(text), ""};
    names.push_back(known);
  }
  if (const auto end = name.find('\n'); end != std::string::npos) return {name.substr(end + 1), ""};
  if (name == "-" || name.find('/') != std::string::npos || name.ends_with(ending)) {
    FileContent file = read_file(name);
    return {std::move(file.content), file.error.empty() ? "" : fmt::format("{}: error: {}", shown(name), file.error)};
  }
  const auto near = nearest_name(name, names);
  return {"", fmt::format("error: unknown {} '{}'; {}", kind, shown(name),
                          near.empty()
                              ? fmt::format("choose one of {}, or a file whose name contains a slash or ends in {}",
                                            fmt::join(names, ", "), ending)
                              : fmt::format("did you mean '{}'?", near))};
}

}  // namespace labmouse
