// labmouse: the command. One file a subcommand; what they do lies in labmouse/lab.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <exception>

#include "command.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace {

/// Tells what went wrong, with foreign names made harmless.
void print_lines(std::string_view text) {
  for (bool more = true; more;) {
    const auto end = text.find('\n');
    labmouse::cli::tell(fmt::format("{}\n", labmouse::shown(text.substr(0, end))));
    more = end != std::string_view::npos;
    if (more) text.remove_prefix(end + 1);
  }
}

/// The first word that a command did not expect, with the option that it may have been meant to be.
std::string describe_unexpected(const CLI::App& command, const std::vector<std::string>& words) {
  auto word = std::find_if(words.begin(), words.end(), [](const std::string& w) { return w.starts_with("-"); });
  if (word == words.end()) return fmt::format("'{}' was not expected", words.front());
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  const auto near = labmouse::nearest_name(*word, std::vector<std::string_view>(names.begin(), names.end()));
  return fmt::format("option '{}' is unknown{}", *word, near.empty() ? "" : fmt::format("; did you mean '{}'?", near));
}

/// Ends as bad usage: one line that says what is wrong and where help is.
int refuse(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* command = &app;
  std::string name = "labmouse";
  while (!command->get_subcommands().empty()) {
    command = command->get_subcommands().front();
    name += " " + command->get_name();
  }
  // A word in the place of a command's own commands is only called a missing one.
  const bool unexpected = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
                          (command != &app && !command->get_subcommands({}).empty());
  const std::vector<std::string> words = app.remaining(true);
  print_lines(fmt::format("error: {} (see `{} --help`)",
                          unexpected && !words.empty() ? describe_unexpected(*command, words) : error.what(), name));
  return labmouse::cli::exit_usage;
}

/// A first word that is no command, which CLI11 would only call a missing one.
void refuse_unknown_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (word.starts_with('-') || std::find(names.begin(), names.end(), word) != names.end()) return;
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  const auto near = labmouse::nearest_name(word, candidates);
  throw labmouse::cli::UsageError(fmt::format(
      "error: command '{}' is unknown; {} (see `labmouse --help`)", word,
      near.empty() ? fmt::format("there are {}", fmt::join(names, ", ")) : fmt::format("did you mean '{}'?", near)));
}

/// An empty path, which a shell makes of a variable that is not set: it would be taken for an option left out.
void refuse_empty_paths(const CLI::App& command) {
  constexpr std::array<std::string_view, 10> paths = {"FILE", "DIR",     "PATH",  "MAZE",  "IN",
                                                      "OUT",  "RESULTS", "ROBOT", "RULES", "INTERPRETER"};
  for (const CLI::Option* option : command.get_options()) {
    const std::string type = option->get_type_name();
    if (std::find(paths.begin(), paths.end(), type.substr(0, type.find(':'))) == paths.end()) continue;
    const std::vector<std::string>& words = option->results();
    if (std::find(words.begin(), words.end(), "") != words.end())
      throw labmouse::cli::UsageError(fmt::format("error: {} is empty; it takes a {} (see `labmouse {} --help`)",
                                                  option->get_name(), type, command.get_name()));
  }
  for (const CLI::App* inner : command.get_subcommands()) refuse_empty_paths(*inner);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace labmouse::cli;
  // A reader that leaves early (`| head`) shows as a failed write; see print.
  std::signal(SIGPIPE, SIG_IGN);
  // A file that grows beyond `ulimit -f` shows as a failed write, too.
  std::signal(SIGXFSZ, SIG_IGN);
  CLI::App app{"labmouse: a laboratory for mice that explore mazes they have never seen", "labmouse"};
  app.set_version_flag("--version", "labmouse " + std::string(labmouse::version()));
  app.require_subcommand(1);
  app.footer(
      "Example: labmouse race --mice flood,certify --worst 3\nExit codes: 0 good, 1 a check found something, 2 bad "
      "usage or input, 128 and the signal when interrupted, 130 for Ctrl-C.");
  int exit = exit_good;
  add_race(app, exit);
  add_sweep(app, exit);
  add_study(app, exit);
  add_tune(app, exit);
  add_run(app, exit);
  add_mms(app, exit);
  add_learn(app, exit);
  add_show(app, exit);
  add_inspect(app, exit);
  add_make(app, exit);
  add_convert(app, exit);
  add_mice(app, exit);
  add_robot(app, exit);
  add_rules(app, exit);
  add_bound(app, exit);
  add_route(app, exit);
  add_replay(app, exit);
  add_score(app, exit);
  add_page(app, exit);
  add_report(app, exit);
  add_bench(app, exit);
  try {
    app.parse_complete_callback([&app] { refuse_empty_paths(app); });
    if (argc > 1) refuse_unknown_command(app, argv[1]);
    app.parse(argc, argv);
    return exit;
  } catch (const CLI::CallForHelp&) {
    return app.exit(CLI::CallForHelp());
  } catch (const CLI::CallForVersion& version) {
    return app.exit(version);
  } catch (const CLI::ParseError& error) {
    return refuse(app, error);
  } catch (const UsageError& error) {
    print_lines(error.what());
    return exit_usage;
  } catch (const std::exception& error) {
    print_lines(std::string("error: ") + error.what());
    return exit_usage;
  }
}
