#include "errors.hpp"

#include "bindings.hpp"

namespace labmouse::python {
namespace {

/// The message without a leading "error: " and without line ends behind it.
std::string bare(std::string line) {
  constexpr std::string_view prefix = "error: ";
  if (line.starts_with(prefix)) line.erase(0, prefix.size());
  while (line.ends_with('\n')) line.pop_back();
  return line;
}

}  // namespace

UserError::UserError(const std::string& line) : std::runtime_error(bare(line)) {}

UserError error_of(const std::vector<SkippedFile>& files) {
  std::string text;
  for (const SkippedFile& file : files)
    for (const Problem& problem : file.problems) text += describe(file.path, problem) + "\n";
  return UserError(text);
}

void bind_errors(nanobind::module_& module) {
  nanobind::exception<UserError>(module, "Error", PyExc_ValueError);
  module.attr("Error").attr("__doc__") =
      "An error in a maze, a mouse or an option. Its text is the line that the command `labmouse` would print.";
}

}  // namespace labmouse::python
