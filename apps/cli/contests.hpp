// What the subcommands that hold many contests share: where and how often, a bar, and Ctrl-C.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "command.hpp"
#include "labmouse/lab/races/tournament.hpp"

namespace labmouse::cli {

struct Contests {
  std::vector<std::string> mazes;
  Places places;
  RaceOrder order;
};
void add_contests(Command& command, Contests& contests);

/// The mice of the SPECs, all of the roster where there is none; throws UsageError, also where one lives in another
/// world. While an Interruptible lives, Ctrl-C ends the guests among them.
std::vector<Contestant> find_contestants(const std::vector<std::string>& specs, GuestOptions options = {});

/// A bar on standard error, where that is a terminal.
class Progress {
 public:
  Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  void advance(std::size_t all);

 private:
  bool shown_;
  std::size_t done_ = 0;
  std::size_t percent_ = 101;
};

/// While one of these lives, Ctrl-C ends no program but raises a flag; one at a time.
class Interruptible {
 public:
  Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;
  ~Interruptible();

  /// Raised by Ctrl-C and by stop(): no further contest begins.
  const std::atomic<bool>& stopped() const;
  void stop();
};

}  // namespace labmouse::cli
