// labmouse: the command. One file a subcommand; what they do lies in labmouse/lab.
#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <exception>

#include "command.hpp"
#include "labmouse/lab/version.hpp"

namespace {

/// Ends as bad usage: one line that says what is wrong and where help is.
int refuse(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  const std::string name = command == &app ? "labmouse" : "labmouse " + command->get_name();
  fmt::print(stderr, "error: {} (see `{} --help`)\n", error.what(), name);
  return labmouse::cli::exit_usage;
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
