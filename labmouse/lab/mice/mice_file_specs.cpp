#include "labmouse/lab/mice/mice_file_specs.hpp"

#include <fmt/format.h>

#include "labmouse/lab/mice/external_specs.hpp"
#include "labmouse/lab/mice/named_spec.hpp"
#include "labmouse/lab/mice_files/mice_file.hpp"
#include "labmouse/lab/system/files.hpp"

namespace labmouse {
namespace {

using Kind = MiceFileEntry::Kind;

/// The text after `mice-file:`, split.
struct NamedMiceFile {
  std::string path, only;  ///< path of the file, and name of one mouse; empty: all
  FileContent file;
};

/// Both names and paths may contain colons: the longest readable path is the file.
NamedMiceFile find_mice_file(const std::string& text) {
  NamedMiceFile found = {text, "", read_file(text)};
  for (auto colon = text.rfind(':'); !found.file.error.empty() && colon != std::string::npos && colon > 0;
       colon = text.rfind(':', colon - 1)) {
    found.path = text.substr(0, colon);
    found.only = text.substr(colon + 1);
    found.file = read_file(found.path);
  }
  return found;
}

/// Why there is no such file.
std::string no_mice_file(const NamedMiceFile& mice_file) {
  const bool many = mice_file.path.find(',') != std::string::npos;
  return fmt::format("mice file {}: {}{}", mice_file.path, mice_file.file.error,
                     many ? "; mice-file: takes everything after its colon, so name other mice before it" : "");
}

/// A path in a mice file, resolved against the file's folder.
std::string beside(const std::string& folder, const std::string& path) {
  return path.empty() || path.starts_with('/') || path.starts_with("~/") || folder.empty() ? path : folder + "/" + path;
}

/// The options of a mouse of the mice file in that folder.
ExternalOptions options_of(const MiceFileEntry& mouse, const std::string& folder, ExternalOptions options) {
  options.limits = mouse.limits.over(options.limits);
  options.runs = mouse.runs.value_or(options.runs);
  options.arguments = mouse.arguments;
  options.environment = mouse.environment;
  options.directory = mouse.directory.empty() ? folder : beside(folder, mouse.directory);
  options.owns_directory = !mouse.directory.empty();
  // A name without a slash is searched in PATH.
  const bool is_path = mouse.interpreter.find('/') != std::string::npos;
  options.interpreter = is_path ? beside(folder, mouse.interpreter) : mouse.interpreter;
  if (mouse.kind == Kind::capstone && !mouse.interpreter.empty()) options.python = options.interpreter;
  return options;
}

/// Replaces each `{parameter}` of a program by the value; returns the number of replacements.
int fill_in(MiceFileEntry& mouse, const Setting& value) {
  const std::string place = "{" + value.name + "}";
  int places = 0;
  const auto fill = [&](std::string& text) {
    for (auto at = text.find(place); at != std::string::npos; at = text.find(place, at + value.value.size()), ++places)
      text.replace(at, place.size(), value.value);
  };
  fill(mouse.what);
  for (std::string& argument : mouse.arguments) fill(argument);
  for (std::string& variable : mouse.environment) fill(variable);
  return places;
}

/// Reads an external mouse of the mice file in that folder into the result; on failure sets its error.
void read_external_of_mice_file(MiceFileEntry mouse, const std::string& folder, const ExternalOptions& options,
                                const Setting* value, SpecResult& result) {
  if (value != nullptr && fill_in(mouse, *value) == 0) {
    result.error = fmt::format("it has no place for the value; write {{{}}} where the value belongs", value->name);
    return;
  }
  const bool is_file = mouse.kind == Kind::capstone || mouse.kind == Kind::firmware;
  const std::string what = is_file ? beside(folder, mouse.what) : mouse.what;
  read_external_spec(fmt::format("{}:{}", key_of(mouse.kind), what), options_of(mouse, folder, options), result);
}

/// Reads a mouse of the mice file in that folder; on failure sets the result's error.
SpecResult read_mouse_of_mice_file(MiceFileEntry mouse, const std::string& folder, const ExternalOptions& options,
                                   const Setting* value, ReadOwnMouse read_own) {
  SpecResult result;
  const bool ours = mouse.kind == Kind::mouse, has_parts = ours && parts_place(mouse.what) != std::string::npos;
  // A value for its program is none for its strategy.
  const bool filled = has_parts && value != nullptr && fill_in(mouse, *value) > 0;
  if (!ours)
    read_external_of_mice_file(mouse, folder, options, value, result);
  else if (has_parts)
    result.error =
        read_own(mouse.what, options_of(mouse, folder, options), filled ? nullptr : value, result.contestants);
  else if (is_external_spec(mouse.what))
    result.error = fmt::format("'{0}' is an external mouse; write {1} = \"...\" in place of mouse = \"{1}:...\"",
                               mouse.what, mouse.what.substr(0, mouse.what.find(':')));
  else
    result.error = read_own(mouse.what, options, value, result.contestants);
  if (!result.error.empty()) return result;
  Contestant& contestant = result.contestants.front();
  if (value == nullptr)
    rename(contestant, mouse.name);
  else if (!ours || filled)
    rename(contestant, fmt::format("{}: {}={}", mouse.name, value->name, value->value));
  contestant.note = mouse.note;
  if (mouse.runs) contestant.runs = *mouse.runs;
  return result;
}

/// Adds a problem of a mice file, with its place, to the result.
void complain(const std::string& path, const Problem& problem, SpecResult& result) {
  // A problem of the file as a whole has no line.
  const std::string place =
      problem.line > 0 ? fmt::format("{}:{}:{}", path, problem.line, problem.column) : std::string(path);
  if (result.error.empty()) result.error = fmt::format("mice file {}: {}", place, problem.reason);
  result.problems.push_back(fmt::format("{}: error: {}", place, problem.reason));
}

}  // namespace

void read_mice_file_spec(std::string_view spec, const ExternalOptions& options, const Setting* value,
                         ReadOwnMouse read_own, SpecResult& result) {
  const NamedMiceFile named = find_mice_file(std::string(spec.substr(spec.find(':') + 1)));
  if (!named.file.error.empty()) {
    result.error = no_mice_file(named);
    return;
  }
  const MiceFileResult mice_file = read_mice_file(named.file.content);
  for (const Problem& problem : mice_file.problems) complain(named.path, problem, result);
  const auto slash = named.path.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : named.path.substr(0, slash);
  bool any = false;
  for (const MiceFileEntry& mouse : mice_file.mice) {
    if (!named.only.empty() && mouse.name != named.only) continue;
    any = true;
    SpecResult one = read_mouse_of_mice_file(mouse, folder, options, value, read_own);
    if (!one.error.empty())
      complain(named.path, {mouse.line, mouse.column, fmt::format("mouse '{}': {}", mouse.name, one.error)}, result);
    for (Contestant& contestant : one.contestants) {
      contestant.mice_file = named.path;
      result.contestants.push_back(std::move(contestant));
    }
  }
  if (!any && result.error.empty())
    result.error = fmt::format("mice file {} has no mouse '{}'", named.path, named.only);
}

}  // namespace labmouse
