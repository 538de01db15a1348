// labmouse: the command. One file a subcommand; what they do lies in labmouse/lab.
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>

#include "command.hpp"
#include "labmouse/lab/version.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace {

/// Ends as bad usage: one line that says what is wrong and where help is.
int refuse(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  const std::string name = command == &app ? "labmouse" : "labmouse " + command->get_name();
  fmt::print(stderr, "error: {} (see `{} --help`)\n", error.what(), name);
  return labmouse::cli::exit_usage;
}

/// A first word that is no command, which CLI11 would only call a missing one.
void refuse_unknown_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (word.starts_with('-') || std::find(names.begin(), names.end(), word) != names.end()) return;
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  const auto near = labmouse::nearest_name(word, candidates);
  throw labmouse::cli::UsageError(fmt::format("error: command '{}' is unknown; {} (see `labmouse --help`)", word,
                                              near.empty() ? fmt::format("there are {}", fmt::join(names, ", "))
                                                           : fmt::format("did you mean '{}'?", near)));
}

}  // namespace

int main(int argc, char** argv) {
  using namespace labmouse::cli;
  // A reader that leaves early (`| head`) shows as a failed write, which says so.
  std::signal(SIGPIPE, SIG_IGN);
  CLI::App app{"labmouse: a laboratory for mice that explore mazes they have never seen", "labmouse"};
  app.set_version_flag("--version", "labmouse " + std::string(labmouse::version()));
  app.require_subcommand(1);
  app.footer("Example: labmouse race --mice flood,certify --worst 3\nExit codes: 0 good, 1 a check found something, 2 bad usage or input.");
  int exit = exit_good;
  add_race(app, exit);
  add_run(app, exit);
  add_show(app, exit);
  add_inspect(app, exit);
  add_make(app, exit);
  add_convert(app, exit);
  add_mice(app, exit);
  add_bound(app, exit);
  add_replay(app, exit);
  add_score(app, exit);
  add_bench(app, exit);
  try {
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
    fmt::print(stderr, "{}\n", error.what());
    return exit_usage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return exit_usage;
  }
}
