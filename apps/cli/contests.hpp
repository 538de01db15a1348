// What the subcommands that run many contests share: options, a progress bar, and handling of the signals that end them
// early.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command.hpp"
#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/result_folders/results_folder.hpp"
#include "labmouse/lab/store/store.hpp"
#include "worlds.hpp"

namespace labmouse::cli {

struct Contests {
  std::vector<std::string> mazes;
  Places places;
  WorldChoice world;
  /// World and number of runs are not set here: the world depends on the mice, and the default of runs on the world.
  RaceOrder order;
  std::optional<int> runs;

  /// The file of --store; empty without one.
  std::string store_path;

  /// The order for that world, with the store opened if --store names one. Throws UsageError if it cannot be opened.
  RaceOrder order_in(std::shared_ptr<const World> chosen) const;
  /// After all contests: waits until the store has them, and prints how many came from it and how many were added.
  /// This goes to standard output if it is `below_a_table`; otherwise to standard error, because a program reads the
  /// output. Throws UsageError if the store failed.
  void finish_store(bool below_a_table) const;

 private:
  mutable std::shared_ptr<Store> store_;
};
/// Adds all options of contests: those of add_mazes() and of add_world_and_seed(), and --runs.
void add_contests(Command& command, Contests& contests);
/// Adds --mazes and the places of start and goal.
void add_mazes(Command& command, Contests& contests, const std::string& default_mazes);
/// Adds --world with its settings, --seed, --store and --jobs.
void add_world_and_seed(Command& command, Contests& contests);

/// Adds the option --shard.
/// @param what has parts: "race".
Option* add_shard(Command& command, Shard& shard, std::string_view what);

/// The mice that were read; throws UsageError with all that is wrong with them.
std::vector<Contestant> mice_of(SpecResult read);

/// The mice of the SPECs; throws UsageError. While an Interruptible lives, Ctrl-C ends the external mice among them.
std::vector<Contestant> find_contestants(const std::vector<std::string>& specs, ExternalOptions options = {});
/// The same; where there is no SPEC, all built-in mice that race in that world.
std::vector<Contestant> find_contestants(const std::vector<std::string>& specs, const WorldChoice& world,
                                         ExternalOptions options = {});

/// Adds the option --mice-file.
void add_mice_files(Command& command, std::vector<std::string>& mice_files);
/// Adds a SPEC for each mice file.
std::vector<std::string> with_mice_files(std::vector<std::string> specs, const std::vector<std::string>& mice_files);

/// The mazes in which the world of the entry runs contests; the world gets the defaults for them. It skips others, but
/// throws UsageError for one that the user named directly. Prints remarks, unless this is done `again` in that world.
MazeCollection find_mazes_of(Entry& entry, const Contests& contests, bool again = false);

/// Reserves the folder of --out for one race, until the result is destroyed; null without --out. Throws UsageError.
std::unique_ptr<ResultsFolder> take_folder(const std::string& out, bool overwrite);

/// The numbers, separated by commas, of an option that is a setting of a world; throws UsageError.
std::vector<double> numbers_of(const WorldSetting& setting, const std::string& text);

/// A bar and the time left on standard error, where that is a terminal.
class Progress {
 public:
  Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  void advance(std::size_t all);

 private:
  bool shown_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point drawn_ = {};
  std::size_t done_ = 0;
  std::size_t percent_ = 101;
};

/// While an object of this class exists, Ctrl-C and the signals SIGTERM and SIGHUP do not end the program but raise a
/// flag. Another such signal, a second later or more, ends the program. Only one object may exist at a time.
class Interruptible {
 public:
  Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;
  ~Interruptible();

  /// Raised by a signal and by stop(): no further contest begins.
  const std::atomic<bool>& stopped() const;
  void stop();
};

/// The exit code of a command that a signal stopped: 128 and the signal, 130 for Ctrl-C.
ExitCode exit_interrupted();

}  // namespace labmouse::cli
