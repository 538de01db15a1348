#include "contests.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace labmouse::cli {
namespace {

std::atomic<bool> stop_flag{false};

}  // namespace

void add_contests(Command& command, Contests& contests) {
  command
      .add_option("--mazes", contests.mazes,
                  "Maze files, folders, patterns or names of built-in mazes; default: all built-in mazes")
      ->type_name("PATH")
      ->expected(1, 1 << 20)
      ->take_all();
  add_places(command, contests.places);
  command.add_option("--runs", contests.order.runs, "Contests of each mouse that throws dice, in each maze")
      ->check(in_range(1, 1'000'000))
      ->capture_default_str();
  add_budget(command, contests.order.rules);
  command.add_option("--seed", contests.order.seed, "Seed of all chance")->check(seed_number())->capture_default_str();
  command.add_option("--jobs", contests.order.jobs, "Threads; 0 takes all processors")
      ->check(in_range(0, 1024))
      ->capture_default_str();
}

std::vector<Contestant> find_contestants(const std::vector<std::string>& specs, GuestOptions options) {
  if (specs.empty()) return all_contestants();
  options.stop = &stop_flag;
  SpecResult result = read_specs(specs, options);
  if (!result.error.empty()) throw UsageError("error: " + result.error);
  if (!result.mms.empty())
    throw UsageError(fmt::format(
        "error: '{}' lives in the world of mms; `labmouse race` races it, `labmouse mms` hosts it in one maze",
        result.mms.front().name));
  return std::move(result.contestants);
}

Progress::Progress() : shown_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (shown_ && done_ > 0) tell("\r\x1b[K");
}

void Progress::advance(std::size_t all) {
  if (!shown_) return;
  const auto percent = ++done_ * 100 / all;
  if (percent == percent_) return;
  percent_ = percent;
  tell(fmt::format("\r[{:<40}] {:>3} %", std::string(percent * 40 / 100, '#'), percent));
}

Interruptible::Interruptible() {
  stop_flag = false;
  std::signal(SIGINT, [](int) { stop_flag = true; });
}

Interruptible::~Interruptible() { std::signal(SIGINT, SIG_DFL); }

const std::atomic<bool>& Interruptible::stopped() const { return stop_flag; }

void Interruptible::stop() { stop_flag = true; }

}  // namespace labmouse::cli
