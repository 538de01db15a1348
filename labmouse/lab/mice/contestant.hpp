// A mouse that takes part in races, and how external mice are started.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "labmouse/contest/controller_code.hpp"
#include "labmouse/contest/record.hpp"
#include "labmouse/contest/rules.hpp"
#include "labmouse/external/hidden_files.hpp"
#include "labmouse/external/launch.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/driving_strategy.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

/// What runs an external mouse's program.
struct Interpreter {
  std::string path;
  std::string version;  ///< of a Python: "3.11.2"; empty for others

  friend bool operator==(const Interpreter&, const Interpreter&) = default;
};

/// A mouse that is asked for each decision.
struct Decider {
  /// Its strategy for a contest in that maze, with that briefing in steps; empty where it does not race in steps.
  std::function<std::unique_ptr<Strategy>(const Maze&, const Briefing&)> make = {};
  /// The same in seconds; empty where it does not race in seconds.
  std::function<std::unique_ptr<DrivingStrategy>(const Maze&, const Briefing&)> drive = {};
};

/// A contest in steps that was run before the race.
struct PlayedContest {
  RunRecord record;
  bool started = true;        ///< as in StrategyReport
  double microseconds = 0.0;  ///< that its decisions took
};

/// A mouse whose contests were run before the race: those in steps, by the name of the maze and the seed.
using PlayedContests = std::map<std::pair<std::string, std::uint64_t>, PlayedContest>;

/// A program that drives a mouse in the physical world itself: what starts it.
using ControllerProgram = std::function<std::unique_ptr<ControllerCode>(const ControllerBriefing&)>;

/// A program that talks to mms: how to start it.
using MmsProgram = Launch;

/// A mouse with its parameters, ready to be made once a contest.
struct Contestant {
  /// The name that its user gave it; otherwise its SPEC in its shortest form: parameters that differ from their
  /// defaults, in the order of the mouse's table.
  std::string name;
  /// Its SPEC, where the name is another.
  std::string spec;
  /// What a mice file says of it: its author, a link.
  std::string note;
  /// Of a capstone robot, and of others where a mice file names one.
  std::optional<Interpreter> interpreter;
  /// The file of the mice file that it stands in, maybe among mice of other worlds: where it cannot race, the others do
  /// without it. Empty for all others.
  std::string mice_file;
  Settings settings;
  bool uses_chance = false;
  /// Contests in each maze; 0: as many as the race holds of a mouse that is stochastic, or one.
  int runs = 0;
  /// Takes part as a measure and not as a contestant (the oracle).
  bool reference = false;
  std::variant<Decider, PlayedContests, ControllerProgram, MmsProgram> kind;
  /// A program that is not ours. It gets the same seed in all mazes of a run.
  bool external = false;
  /// Of an external mouse whether it lives in a sandbox; nothing for all others.
  std::optional<bool> sandboxed;
  std::string why_no_sandbox;  ///< where the system has none
  bool keeps_folder =
      false;                ///< of an external mouse: it writes to its folder itself, and may remember earlier contests
  bool reads_only = false;  ///< of an external mouse: its folder is read-only, because the system has no overlays
  /// The files that an external mouse does not see, a list to add to; null for all others.
  std::shared_ptr<HiddenFiles> hidden;
  /// What it is, as a text that is another one where it may play otherwise: for stores of contests. Empty for mice of
  /// ours, whose names and parameters say it; of an external mouse it reads files.
  std::function<std::string()> identity;
  /// Only of a mouse that learns from whole mazes before it races: the same mouse with what these mazes teach in place
  /// of what it brings along. Studies call it with the mazes of all folds but one, in the order of their names; it may
  /// remember nothing from one call to the next, must give equal mice for equal mazes, and keeps uses_chance. Once
  /// `stop`, which may be null, is true, it learns no more, and the mouse is not to be raced.
  std::function<Contestant(const std::vector<const Maze*>& training, const Rules&, const std::atomic<bool>* stop)>
      taught;

  /// Whether it races in steps.
  bool walks() const;
  /// Whether it races in seconds, asked for each decision.
  bool drives() const;
  /// Of a Decider that walks: its strategy for a contest in that maze, with that briefing in steps.
  std::unique_ptr<Strategy> strategy(const Maze& maze, const Briefing& briefing) const;
  /// The same in seconds, of one that drives.
  std::unique_ptr<DrivingStrategy> driving_strategy(const Maze& maze, const Briefing& briefing) const;
};

/// The SPEC of a mouse, whatever it is called.
inline const std::string& spec_of(const Contestant& mouse) { return mouse.spec.empty() ? mouse.name : mouse.spec; }

/// What external mice without a sandbox could do to the machine that they ran on and to the race, and what those with
/// one could remember, in lines; nothing where there is nothing to say.
std::string freedom_note(const std::vector<Contestant>& mice);

/// Gives a mouse another name, which it keeps when it learns.
void rename(Contestant& mouse, const std::string& name);

/// Mice, or the reason why the text is no SPEC: exactly one of the two is there.
struct SpecResult {
  std::vector<Contestant> contestants;
  std::string error;
  /// Where a mice file is wrong all that is, a line each with its place; the error is the first of them.
  std::vector<std::string> problems = {};
};

/// Whether external mice live in sandboxes.
enum class SandboxUse { where_possible, always, never };

/// What is installed for the Pythons of external mice: found out once for all external mice of a race, since that
/// starts each Python.
struct InstalledPackages {
  std::mutex mutex;
  std::map<std::vector<std::string>, std::string> known;  ///< by the program and what its environment has besides ours
};

/// How external mice are started.
struct ExternalOptions {
  std::string python;          ///< for capstone robots; empty: the python3 of PATH
  std::string label;           ///< stands for the content of their files in stores of contests; empty: what they hold
  std::string directory;       ///< where commands run; empty: here
  bool owns_directory = true;  ///< whether that, where it is named, is the folder of the mouse
  /// What a mice file says of one external mouse: what is put before the words of its command and behind them, and
  /// variables of its environment as NAME=VALUE.
  std::string interpreter;
  std::vector<std::string> arguments, environment;
  ExternalLimits limits;
  SandboxUse sandbox = SandboxUse::where_possible;
  bool keep_folder = false;  ///< as of Launch
  /// What they do not see: a list that copies of these options share. The mazes of a race are added by the race.
  std::shared_ptr<HiddenFiles> hidden = std::make_shared<HiddenFiles>();
  std::shared_ptr<InstalledPackages> packages = std::make_shared<InstalledPackages>();  ///< as of the list before
  int runs = 1;                             ///< contests of each external mouse in each maze
  const std::atomic<bool>* stop = nullptr;  ///< once true, external mice are ended; may be null
};

}  // namespace labmouse
