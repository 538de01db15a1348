// Finds a text by the name of a built-in one or by the path of a file.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace labmouse {

/// A text, or an error as a line for the user.
struct NamedText {
  std::string text;
  std::string error;
};

/// Finds a text: a built-in one by its name, or a file (a name with a slash, one that ends in `ending`, or `-`). `kind`
/// is the word for such a text in errors, such as "robot". In the browser, which has no files, a name may be followed
/// by a line feed and the text itself.
template <class Builtin>
NamedText find_text(std::string_view kind, const Builtin& builtins, const std::string& name,
                    std::string_view ending = ".toml");

/// The name before the first line feed.
inline std::string name_alone(const std::string& name) { return name.substr(0, name.find('\n')); }

/// The same for a list of names and texts.
NamedText find_text(std::string_view kind, const std::vector<std::pair<std::string_view, std::string_view>>& builtins,
                    const std::string& name, std::string_view ending);

template <class Builtin>
NamedText find_text(std::string_view kind, const Builtin& builtins, const std::string& name, std::string_view ending) {
  std::vector<std::pair<std::string_view, std::string_view>> texts;
  for (const auto& builtin : builtins) texts.emplace_back(builtin.name, builtin.text);
  return find_text(kind, texts, name, ending);
}

}  // namespace labmouse
