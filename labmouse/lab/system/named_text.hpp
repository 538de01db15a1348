// What the program brings under a name, and users under the path of a file.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace labmouse {

/// A text, or why there is none, as a line for the user.
struct NamedText {
  std::string text;
  std::string error;
};

/// The built-in text of that name, or that of a file, whose name has a slash or that ending, or is `-`. `kind` is
/// what such a thing is called: "robot". Where there are no files, a text can be given with its name: in the first of
/// its lines.
template <class Builtin>
NamedText find_text(std::string_view kind, const Builtin& builtins, const std::string& name,
                    std::string_view ending = ".toml");

/// The name alone, of one that a text was given with.
inline std::string name_alone(const std::string& name) { return name.substr(0, name.find('\n')); }

/// The same of a list of names and texts.
NamedText find_text(std::string_view kind, const std::vector<std::pair<std::string_view, std::string_view>>& builtins,
                    const std::string& name, std::string_view ending);

template <class Builtin>
NamedText find_text(std::string_view kind, const Builtin& builtins, const std::string& name, std::string_view ending) {
  std::vector<std::pair<std::string_view, std::string_view>> texts;
  for (const auto& builtin : builtins) texts.emplace_back(builtin.name, builtin.text);
  return find_text(kind, texts, name, ending);
}

}  // namespace labmouse
