// labmouse doctor: what works on this machine, and how to get the rest.
#include <fmt/format.h>

#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "command.hpp"
#include "embedded_page.hpp"
#include "labmouse/external/capstone.hpp"
#include "labmouse/external/command_line.hpp"
#include "labmouse/external/sandbox.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "robot_fit.hpp"
#include "terminal.hpp"

namespace labmouse::cli {
namespace {

struct Part {
  std::string name;
  bool there = false;
  std::string found;  ///< what was found, or why there is none
  std::string gives;  ///< what it is needed for
  std::string how;    ///< how to get it
};

Part python_part() {
  Part part{"Python", false, "", "capstone robots, `labmouse robot fit`", "install Debian's package python3"};
  const std::string python = python_of_fits(), version = python_version(python, false);
  part.there = !version.empty();
  part.found = part.there ? fmt::format("{}, {}", version, program_path(python, ""))
                          : fmt::format("no program {} that is a Python", python);
  return part;
}

Part package_part(std::string name, const std::vector<std::string>& modules, std::string gives,
                  std::string_view extra) {
  Part part{std::move(name), false, "", std::move(gives),
            fmt::format("run `pip install -v {}` in the source folder", extra)};
  const std::string python = python_of_fits(), version = labmouse_version_in(python, modules);
  part.there = !version.empty();
  part.found = part.there ? version : fmt::format("{} has none", python);
  return part;
}

Part sandbox_part() {
  const std::string why = why_no_sandbox();
  return {"sandbox", why.empty(), why.empty() ? "works" : why,
          "races with programs that cannot read mazes, other files or the network",
          "allow user namespaces (docs/how-to/install.md)"};
}

Part page_part() {
  const std::size_t size = embedded_page().size();
  return {"page", size > 0, size > 0 ? fmt::format("inside, {} KiB", size / 1024) : "not inside",
          "`labmouse demo`, `labmouse page`, `labmouse report`",
          "run `make page`, then `make race`, in the source folder"};
}

Part terminal_part() {
  const std::optional<TerminalSize> size = terminal_size();
  return {"terminal", size.has_value(),
          size ? fmt::format("{}x{}{}", size->columns, size->rows, colours() ? ", colours" : ", no colours")
               : "output goes elsewhere",
          "`--watch`, progress bars", "run labmouse in a terminal"};
}

std::vector<Part> all_parts() {
  return {sandbox_part(),
          page_part(),
          python_part(),
          package_part("labmouse for Python", {}, "mice as classes, `import labmouse`", "."),
          package_part("labmouse.fit", {"scipy", "matplotlib"}, "`labmouse robot fit`", "'.[fit]'"),
          terminal_part()};
}

std::string table(const std::vector<Part>& parts) {
  std::string text = fmt::format("labmouse {}, {}; {} threads of {}\n\n", version(), compiler(),
                                 std::thread::hardware_concurrency(), processor());
  for (const Part& part : parts) {
    text += fmt::format("{:<4}{:<21}{}\n", part.there ? "yes" : "no", part.name, shown(part.found));
    if (!part.there) text += fmt::format("    needed for {}; {}\n", part.gives, part.how);
  }
  return text;
}

std::string json_of(const std::vector<Part>& parts) {
  Json json = {{"labmouse", version()}, {"compiler", compiler()}, {"processor", processor()}};
  for (const Part& part : parts)
    json["parts"].push_back({{"name", part.name},
                             {"there", part.there},
                             {"found", part.found},
                             {"needed_for", part.gives},
                             {"how_to_get", part.how}});
  return json.dump(1) + "\n";
}

}  // namespace

void add_doctor(Command& app, int& exit) {
  auto format = std::make_shared<std::string>("table");
  Command* command = app.add_subcommand("doctor", "Show what works on this machine, and how to get the rest");
  command->add_option("--format", *format, "What is printed")->check(one_of({"table", "json"}))->capture_default_str();
  command->footer(
      "The exit code is 0 in any case, because nothing of this is needed for built-in mice.\n\n"
      "Example: labmouse doctor");
  command->callback([format, &exit] {
    const std::vector<Part> parts = all_parts();
    print(*format == "json" ? json_of(parts) : table(parts));
    exit = exit_good;
  });
}

}  // namespace labmouse::cli
