#include "labmouse/lab/mice/external_specs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <mutex>
#include <vector>

#include "labmouse/external/capstone.hpp"
#include "labmouse/external/command_line.hpp"
#include "labmouse/external/external_controller.hpp"
#include "labmouse/external/external_parts.hpp"
#include "labmouse/external/external_strategy.hpp"
#include "labmouse/external/firmware.hpp"
#include "labmouse/external/mms/driven_mms.hpp"
#include "labmouse/external/sandbox.hpp"
#include "labmouse/external/surroundings.hpp"
#include "labmouse/lab/mice/controller_lines.hpp"
#include "labmouse/lab/mice/external_identity.hpp"
#include "labmouse/lab/mice/maze_holders.hpp"
#include "labmouse/lab/robots/builtin_boards.hpp"
#include "labmouse/lab/text/former_names.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/mouse/driven_steps.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;

/// Environment variable that fixes the iteration order of Python sets of text, so that a contest is reproducible.
std::string python_hash_seed(std::uint64_t seed) {
  return fmt::format("PYTHONHASHSEED={}", static_cast<std::uint32_t>(seed));
}

/// The absolute path; a name without a slash, which is searched in PATH, stays.
std::string anchored(const std::string& path) {
  std::error_code error;
  const fs::path absolute = path.find('/') == std::string::npos ? fs::path(path) : fs::absolute(path, error);
  return error ? path : absolute.string();
}

Launch seeded(Launch launch, std::uint64_t seed) {
  launch.environment.push_back(python_hash_seed(seed));
  return launch;
}

/// An external mouse of that kind. `runs` is the number of contests in each maze.
Contestant contestant_of(std::string_view kind, const Launch& launch, int runs) {
  Contestant contestant;
  if (kind == "mms:") {
    contestant.runs = runs;
    contestant.kind = MmsProgram{seeded(launch, 0), [launch](const Briefing& briefing) {
                                   return std::make_unique<DrivenMms>(seeded(launch, briefing.seed), briefing);
                                 }};
  } else if (kind == parts_key) {
    contestant.parts = [launch](const ControllerBriefing& briefing) {
      return std::make_unique<ExternalParts>(seeded(launch, briefing.seed), controller_lines(briefing));
    };
  } else if (kind == "controller:" || kind == "firmware:") {
    contestant.kind = [launch](const ControllerBriefing& briefing) {
      return std::make_unique<ExternalController>(
          seeded(launch, briefing.seed), controller_lines(briefing),
          SpeedControl(*briefing.model.robot.hardware, briefing.model.tables.cell));
    };
  } else {
    contestant.runs = runs;
    const auto make = [launch](const Maze&, const Briefing& briefing) {
      return std::make_unique<ExternalStrategy>(seeded(launch, briefing.seed), briefing);
    };
    const auto drive = [launch](const Maze& maze, const Briefing& briefing) {
      auto mouse = std::make_unique<ExternalStrategy>(seeded(launch, briefing.seed), steps_briefing(briefing));
      return std::make_unique<DrivenSteps>(briefing, maze.open_walls(), std::move(mouse));
    };
    contestant.kind = Decider{make, drive};
  }
  return contestant;
}

/// Expands `~/`, because a shell does not expand it after a colon.
std::string from_home(const std::string& file) {
  const char* home = std::getenv("HOME");
  return file.starts_with("~/") && home != nullptr ? home + file.substr(1) : file;
}

/// Why a file is not that of a capstone robot.
std::string no_robot(const std::string& file) {
  std::error_code failure;
  if (fs::is_directory(file, failure))
    return fmt::format("'{}' is a folder; name the Python file that defines the class Robot", file);
  const auto comma = file.find(',');
  if (comma != std::string::npos && fs::exists(file.substr(0, comma), failure))
    return fmt::format(
        "no such file '{}'; an external mouse takes everything after its colon, so name other mice before it or with "
        "another "
        "--mice",
        file);
  return fmt::format("no such file '{}'; write capstone:FILE, with the Python file that defines the class Robot", file);
}

/// Why the first word of a command is not a program.
std::string no_program(const std::string& name, const std::string& directory) {
  std::error_code failure;
  const fs::path path = fs::path(directory) / name;
  const std::string ending = fs::path(name).extension().string();
  if (!fs::exists(path, failure)) {
    if (name.find('/') == std::string::npos)
      return fmt::format("no program '{}' in PATH; to run a file, include a slash, as in ./mouse", name);
    if (name.starts_with('~')) return fmt::format("no file '{}'; no shell expands ~, so write the full path", name);
    const std::string place = directory.empty() ? "the current folder" : fmt::format("'{}'", directory);
    return fmt::format("no file '{}'{}", name, path.is_absolute() ? "" : fmt::format(" in {}", place));
  }
  if (ending == ".py") return fmt::format("'{}' is not executable; write 'python3 {}'", name, name);
  if (ending == ".js") return fmt::format("'{}' is not executable; write 'node {}'", name, name);
  if (name.find('/') == std::string::npos && access(path.c_str(), X_OK) == 0)
    return fmt::format("'{}' is not in PATH; to run the file, write ./{}", name, name);
  return fmt::format("'{0}' is not executable; if it is a script or a program, run `chmod +x {0}`", path.string());
}

/// An external mouse, or why it cannot be one.
struct External {
  Launch launch;
  std::optional<Interpreter> interpreter;
  std::string error;
};

External no_external(std::string error) { return {{}, {}, std::move(error)}; }

bool has_sandbox(const ExternalOptions& options) {
  return options.sandbox != SandboxUse::never && why_no_sandbox().empty();
}

/// The interpreter of that name, and an error text, which is empty on success.
std::pair<Interpreter, std::string> find_interpreter(const std::string& named, bool sandbox) {
  Interpreter found = {program_path(named, ""), ""};
  if (found.path.empty()) return {found, fmt::format("no executable interpreter '{}'", named)};
  if (fs::path(named).filename().string().find("python") == std::string::npos) return {found, ""};
  found.version = python_version(found.path, sandbox);
  return {found, found.version.empty() ? fmt::format("'{}' is not a working Python interpreter", named) : ""};
}

/// Reads the text after `capstone:`: a file, then arguments separated by blanks.
External robot_of(const std::string& named, const ExternalOptions& options) {
  std::error_code failure;
  std::vector<std::string> words = {from_home(named)};
  if (!fs::exists(words.front(), failure)) words = split_command(named);
  const std::string file = words.empty() ? "" : from_home(words.front());
  if (!fs::is_regular_file(file, failure)) return no_external(no_robot(words.size() > 1 ? file : from_home(named)));
  words.erase(words.begin());
  words.insert(words.end(), options.arguments.begin(), options.arguments.end());
  const std::string python = options.python.empty() ? usual_python : anchored(from_home(options.python));
  if (options.python.empty() && program_path(python, "").empty())
    return no_external(fmt::format("no {} was found in PATH; name one with --python", python));
  auto [interpreter, error] = find_interpreter(python, has_sandbox(options));
  // A capstone robot needs Python, even if the interpreter's name does not contain "python".
  if (error.empty() && interpreter.version.empty())
    interpreter.version = python_version(interpreter.path, has_sandbox(options));
  if (error.empty() && interpreter.version.empty())
    error = fmt::format("'{}' is not a working Python interpreter", python);
  return {capstone_launch(fs::absolute(file, failure).string(), python, words), interpreter, error};
}

/// Reads the text after `firmware:`: an ELF file, then a board if it has one of its own.
External firmware_of(const std::string& named, const ExternalOptions& options) {
  std::error_code failure;
  std::vector<std::string> words = {from_home(named)};
  if (!fs::exists(words.front(), failure)) words = split_command(named);
  const std::string file = words.empty() ? "" : from_home(words.front());
  if (!fs::is_regular_file(file, failure))
    return no_external(fmt::format("no such file '{}'; write firmware:FILE, with the ELF file that avr-gcc links",
                                   words.size() > 1 ? file : from_home(named)));
  words.erase(words.begin());
  words.insert(words.end(), options.arguments.begin(), options.arguments.end());
  if (words.size() > 1) return no_external("it has more than one board; write firmware:FILE or firmware:FILE BOARD");
  std::string board = !words.empty() ? words.front() : options.board.empty() ? usual_board : options.board;
  std::vector<std::string_view> built_in;
  for (const BuiltinBoard& each : builtin_boards()) built_in.push_back(each.name);
  if (std::find(built_in.begin(), built_in.end(), board) == built_in.end()) {
    // The arguments of a mice file lie in its folder.
    const fs::path beside = words.empty() || options.arguments.empty() ? "" : options.directory;
    const std::string path = (beside / from_home(board)).string();
    if (!fs::is_regular_file(path, failure))
      return no_external(fmt::format("no board file '{}', and no built-in board of that name; there is {}", path,
                                     fmt::join(built_in, ", ")));
    board = fs::absolute(path, failure).string();
  }
  const std::string runner = firmware_runner();
  if (runner.empty())
    return no_external(
        fmt::format("there is no {0}, which runs firmware; install libsimavr-dev and build labmouse "
                    "again, or put {0} in PATH",
                    firmware_runner_name));
  return {firmware_launch(runner, fs::absolute(file, failure).string(), board), Interpreter{runner, ""}, ""};
}

External program_of_command(const std::string& command, const ExternalOptions& options) {
  External external;
  std::vector<std::string>& words = external.launch.words;
  words = split_command(command);
  external.launch.directory = from_home(options.directory);
  external.launch.owns_directory = !options.directory.empty() && options.owns_directory;
  const std::string& directory = external.launch.directory;
  std::error_code failure;
  if (!directory.empty() && !fs::is_directory(directory, failure))
    return no_external(fmt::format("there is no folder '{}' to run it in", directory));
  if (has_open_quote(command))
    return no_external("its command has an unclosed quotation mark; for a literal quotation mark write \"\"\"");
  if (words.empty()) return no_external("its command is empty");
  if (!options.interpreter.empty()) {
    const std::string named = anchored(from_home(options.interpreter));
    auto [interpreter, error] = find_interpreter(named, has_sandbox(options));
    if (!error.empty()) return no_external(error);
    words.insert(words.begin(), named);
    external.interpreter = interpreter;
  }
  if (program_path(words.front(), directory).empty()) return no_external(no_program(words.front(), directory));
  words.insert(words.end(), options.arguments.begin(), options.arguments.end());
  return external;
}

/// Identifies the program that runs an external mouse: its content, and for Python the version and the installed
/// packages. Starts that Python. A label replaces all this.
std::string runner_identity(const Launch& launch, InstalledPackages& packages) {
  const std::string path = program_path(launch.words.front(), launch.directory);
  std::string text = program_identity(path);
  if (fs::path(path).filename().string().find("python") == std::string::npos) return text;
  std::vector<std::string> runner = launch.environment;
  runner.push_back(path);
  const std::lock_guard lock(packages.mutex);
  const auto [place, is_new] = packages.known.try_emplace(runner);
  if (is_new) place->second = python_packages(path, launch.environment, launch.sandbox);
  text += fmt::format("python {} packages {}\n", python_version(path, launch.sandbox), place->second);
  return text;
}

/// The files that a mouse sees in its sandbox. Hides files with mazes in its folder, and in those that it names.
std::shared_ptr<const Surroundings> surroundings_for(const Launch& launch, HiddenFiles& hidden) {
  auto around = std::make_shared<const Surroundings>(
      surroundings_of(launch, program_path(launch.words.front(), launch.directory)));
  hide_mazes_in(around->folder, hidden);
  for (const std::string& folder : around->named) hide_mazes_in(folder, hidden);
  return around;
}

}  // namespace

void read_external_spec(std::string_view given, const ExternalOptions& options, SpecResult& result) {
  const std::string spec = today_spec(given);
  const auto place = parts_place(spec);
  const bool has_parts = place != std::string::npos;
  const std::string_view kind = has_parts ? parts_key : std::string_view(spec).substr(0, spec.find(':') + 1);
  const std::string rest(spec.substr((has_parts ? place : 0) + kind.size()));
  // The SPEC becomes the mouse's name in output, and words of it become zero-terminated arguments.
  if (shown(spec) != spec) {
    result.error = fmt::format("mouse '{}': its SPEC contains unprintable characters", shown(spec));
    return;
  }
  External external = kind == "capstone:"   ? robot_of(rest, options)
                      : kind == "firmware:" ? firmware_of(rest, options)
                                            : program_of_command(rest, options);
  if (options.sandbox == SandboxUse::always && !why_no_sandbox().empty())
    external.error = fmt::format("this system has no sandboxes ({}); leave out --sandbox on", why_no_sandbox());
  if (!external.error.empty()) {
    result.error = fmt::format("mouse '{}': {}", spec, external.error);
    return;
  }
  Launch& launch = external.launch;
  launch.limits = options.limits;
  launch.stop = options.stop;
  launch.environment = options.environment;
  launch.sandbox = has_sandbox(options);
  launch.keeps_folder = options.keep_folder;
  launch.hidden = options.hidden;
  if (launch.sandbox) launch.surroundings = surroundings_for(launch, *options.hidden);
  Contestant& mouse = result.contestants.emplace_back(contestant_of(kind, launch, options.runs));
  mouse.name = spec;
  mouse.interpreter = external.interpreter;
  mouse.identity = [kind = has_parts ? "parts" : std::string(kind.substr(0, kind.size() - 1)), launch,
                    interpreter = external.interpreter, label = options.label, packages = options.packages] {
    return external_identity(kind, launch, interpreter, label) +
           (label.empty() ? runner_identity(launch, *packages) : "");
  };
  mouse.external = true;
  mouse.sandboxed = launch.sandbox;
  mouse.keeps_folder = launch.sandbox && launch.keeps_folder;
  mouse.reads_only = launch.sandbox && !launch.keeps_folder && usual_folder_use() == FolderUse::read_only;
  mouse.hidden = options.hidden;
  if (options.sandbox == SandboxUse::where_possible) mouse.why_no_sandbox = why_no_sandbox();
}

}  // namespace labmouse
