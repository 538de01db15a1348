// labmouse: the command line. Each subcommand has its own file; labmouse/lab does the work.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>

#include "command.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "terminal.hpp"

namespace {

/// Prints lines to standard error, made safe for terminals.
void print_lines(std::string_view text) {
  for (bool more = true; more;) {
    const auto end = text.find('\n');
    labmouse::cli::tell(fmt::format("{}\n", labmouse::shown(text.substr(0, end))));
    more = end != std::string_view::npos;
    if (more) text.remove_prefix(end + 1);
  }
}

/// Memory that is freed when there is no other left, because some destructors need a little during unwinding, and an
/// exception from a destructor ends the program without a message.
std::unique_ptr<std::byte[]> reserve;
std::atomic_flag gave_back = ATOMIC_FLAG_INIT;

void give_back_and_fail() {
  if (!gave_back.test_and_set()) reserve.reset();
  throw std::bad_alloc();
}

void set_memory_aside() {
  constexpr std::size_t bytes = std::size_t{4} << 20U;
  reserve = std::make_unique_for_overwrite<std::byte[]>(bytes);
  std::set_new_handler(give_back_and_fail);
}

constexpr const char* start_page =
    R"(labmouse {}: a micromouse laboratory

  labmouse demo                                  race four mice, and open the page with their replays
  labmouse race --mice flood,capstone:robot.py   race your own mouse; a program for mms is 'mms:COMMAND'
  labmouse doctor                                show what works on this machine, and how to get the rest

All commands: labmouse --help. All options of a command: labmouse COMMAND --help.
)";

}  // namespace

int main(int argc, char** argv) {
  using namespace labmouse::cli;
  let_writes_fail();
  set_memory_aside();
  CommandLine line("labmouse", "labmouse: a micromouse laboratory", "labmouse " + std::string(labmouse::version()));
  line.start_page(fmt::format(start_page, labmouse::version()));
  Command& app = line.root();
  app.footer(
      "Example: labmouse race --mice flood,certify --worst 3\nExit codes: 0 success, 1 a check failed, 2 bad usage or "
      "input, 128 plus the signal number when interrupted (130 for Ctrl-C).");
  int exit = exit_good;
  add_race(app, exit);
  add_compare(app, exit);
  add_sweep(app, exit);
  add_study(app, exit);
  add_tune(app, exit);
  add_mice_file(app, exit);
  add_grade(app, exit);
  add_league(app, exit);
  add_run(app, exit);
  add_mms(app, exit);
  add_learn(app, exit);
  add_show(app, exit);
  add_live(app, exit);
  add_inspect(app, exit);
  add_make(app, exit);
  add_convert(app, exit);
  add_mice(app, exit);
  add_robot(app, exit);
  add_rules(app, exit);
  add_bound(app, exit);
  add_route(app, exit);
  add_drive(app, exit);
  add_failure_rates(app, exit);
  add_replay(app, exit);
  add_score(app, exit);
  add_page(app, exit);
  add_report(app, exit);
  add_store(app, exit);
  add_bench(app, exit);
  add_demo(app, exit);
  add_doctor(app, exit);
  try {
    return line.run(argc, argv) ? exit_good : exit;
  } catch (const UsageError& error) {
    print_lines(error.what());
    return exit_usage;
  } catch (const std::bad_alloc&) {
    // No text is formatted here, because there is no memory for it.
    std::fputs(
        "error: out of memory; use fewer contests at once (--runs, --mazes, or --shard with --store), or raise the "
        "limit of `ulimit -v`\n",
        stderr);
    return exit_usage;
  } catch (const std::exception&) {
    // Wrong input throws UsageError, so this is a bug; its message would not help a user.
    tell("error: labmouse failed, and it is not your fault; please report this with the command and its files\n");
    return exit_usage;
  }
}
