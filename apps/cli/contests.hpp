// What the subcommands that hold many contests share: where and how often, a bar, and what ends them early.
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
  /// Without its world, which depends on the mice, and without runs that nobody asked for, which depend on the world.
  RaceOrder order;
  std::optional<int> runs;

  /// The file of --store; empty without one.
  std::string store_path;

  /// Opens the store, where there is one to open; throws UsageError.
  RaceOrder order_in(std::shared_ptr<const World> chosen) const;
  /// After all contests: waits until the store has them, and says what came from it and what was added, below a table
  /// or, where a program reads the output, on standard error. Throws UsageError where the store failed.
  void finish_store(bool below_a_table) const;

 private:
  mutable std::shared_ptr<Store> store_;
};
void add_contests(Command& command, Contests& contests);

/// The mice that were read; throws UsageError with all that is wrong with them.
std::vector<Contestant> mice_of(SpecResult read);

/// The mice of the SPECs; throws UsageError. While an Interruptible lives, Ctrl-C ends the external mice among them.
std::vector<Contestant> find_contestants(const std::vector<std::string>& specs, ExternalOptions options = {});
/// The same; where there is no SPEC, all built-in mice that race in that world.
std::vector<Contestant> find_contestants(const std::vector<std::string>& specs, const WorldChoice& world,
                                         ExternalOptions options = {});

/// --mice file, files of mice.
void add_mice_files(Command& command, std::vector<std::string>& mice_files);
/// SPECs of mice and of the files of mice files.
std::vector<std::string> with_mice_files(std::vector<std::string> specs, const std::vector<std::string>& mice_files);

/// The mazes in which that world holds contests; of those that were named directly none may be refused.
MazeCollection find_mazes_of(const World& world, const Contests& contests);

/// Takes the folder of --out for one race, until the pointer goes; nothing where none was asked for. Throws UsageError.
std::unique_ptr<ResultsFolder> take_folder(const std::string& out, bool overwrite);

/// The numbers of an option that is a setting of a world, which commas part; throws UsageError.
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

/// While one of these lives, Ctrl-C and the signals SIGTERM and SIGHUP do not end the program but raise a flag; another
/// one, a second later or more, ends it all the same. One at a time.
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
