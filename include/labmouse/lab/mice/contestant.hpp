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
#include "labmouse/controller/parts.hpp"
#include "labmouse/external/hidden_files.hpp"
#include "labmouse/external/launch.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/driving_strategy.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse {

/// What runs an external mouse's program.
struct Interpreter {
  std::string path;     ///< of the executable that was found
  std::string version;  ///< of Python: "3.11.2"; empty for others

  friend bool operator==(const Interpreter&, const Interpreter&) = default;
};

/// A mouse that decides step by step when asked.
struct Decider {
  /// Makes its strategy for a contest in a maze, with a briefing in steps; empty if it does not race in steps. A mouse
  /// must not use the maze; it is for the oracle and for the simulation around a mouse.
  std::function<std::unique_ptr<Strategy>(const Maze&, const Briefing&)> make = {};
  /// The same in seconds; empty if it does not race in seconds.
  std::function<std::unique_ptr<DrivingStrategy>(const Maze&, const Briefing&)> drive = {};
};

/// A contest in steps whose record existed before the race.
struct PlayedContest {
  RunRecord record;
  bool started = true;        ///< as in StrategyReport
  double microseconds = 0.0;  ///< total time of its decisions, µs
};

/// A mouse whose contests in steps were run before the race, by name of the maze and seed.
using PlayedContests = std::map<std::pair<std::string, std::uint64_t>, PlayedContest>;

/// Starts a program that is the controller of a mouse in the physical world.
using ControllerProgram = std::function<std::unique_ptr<ControllerCode>(const ControllerBriefing&)>;

/// Starts a program that has parts of the controller of a mouse in the physical world.
using PartsProgram = std::function<std::unique_ptr<PartsOwner>(const ControllerBriefing&)>;

/// A program that talks to mms.
struct MmsProgram {
  Launch launch;  ///< how to start it
  /// Starts it as a strategy for a contest with a briefing in seconds.
  std::function<std::unique_ptr<DrivingStrategy>(const Briefing&)> drive = {};
};

/// A mouse with its parameters; each contest makes a new strategy or process of it.
struct Contestant {
  /// The name that the user gave it, otherwise its SPEC (the text that selects a mouse, see specs.hpp) in its shortest
  /// form: only parameters that differ from their defaults, in the order of the mouse's table.
  std::string name;
  /// Its SPEC; empty if it equals the name.
  std::string spec;
  /// Its note in a mice file, such as author or link.
  std::string note;
  /// Set for capstone robots and firmware, and for others if a mice file names one.
  std::optional<Interpreter> interpreter;
  /// The path of its mice file, or empty. A mice file may contain mice of several worlds; those that cannot race in a
  /// world are left out there.
  std::string mice_file;
  Settings settings;         ///< of a built-in mouse; empty for others
  bool uses_chance = false;  ///< whether it is stochastic with these settings, so that contests are repeated
  /// Contests in each maze. With 0 a stochastic mouse, or any in a stochastic world, has as many as the race sets,
  /// others one.
  int runs = 0;
  /// Whether it runs as a reference outside of the ranking (the oracle).
  bool reference = false;
  std::variant<Decider, PlayedContests, ControllerProgram, MmsProgram> kind;
  /// Parts of its controller that are another program; empty: all are built in. Only for a built-in mouse.
  PartsProgram parts;
  /// Whether it, or parts of its controller, is an external program. It gets the same seed in all mazes of a run.
  bool external = false;
  /// For an external mouse, whether it runs in a sandbox; empty for others.
  std::optional<bool> sandboxed;
  std::string why_no_sandbox;  ///< the reason, if the system has no sandboxes
  bool keeps_folder = false;   ///< external mouse: it may write to its own folder, and so remember earlier contests
  bool reads_only = false;     ///< external mouse: its folder is read-only, because the system has no overlays
  /// Files hidden from an external mouse, a list to add to; null for others.
  std::shared_ptr<HiddenFiles> hidden;
  /// Makes a text for stores of contests that changes whenever the mouse may behave differently. It reads the files of
  /// an external mouse. Empty for built-in mice, which name and parameters identify; with external parts, it is that of
  /// the parts.
  std::function<std::string()> identity;
  /// Only for a mouse that learns from whole mazes before it races: makes the same mouse, trained on these mazes in
  /// place of its built-in prior. Cross-validation calls it with the mazes of all folds but one, sorted by name. It
  /// must be stateless and deterministic, and keep uses_chance. When `stop`, which may be null, becomes true, it stops
  /// learning, and the result must not race.
  std::function<Contestant(const std::vector<const Maze*>& training, const Rules&, const std::atomic<bool>* stop)>
      taught;

  /// Whether it races in steps.
  bool walks() const;
  /// Whether it races in seconds as a strategy. False for a program that is the controller itself.
  bool drives() const;
  /// Makes its strategy for a contest in steps. Starts the program of an external mouse.
  /// @param maze the maze of the contest; only the oracle uses it.
  /// @param briefing in steps; copied, so it need not outlive the result.
  /// @return new, never null.
  /// @pre `kind` is a Decider, and walks().
  std::unique_ptr<Strategy> strategy(const Maze& maze, const Briefing& briefing) const;
  /// Makes its strategy for a contest in seconds. Starts the program of an external mouse.
  /// @param maze the maze of the contest; only the simulation around an external mouse uses it.
  /// @param briefing in seconds; copied, but what it points to must outlive the result.
  /// @return new, never null.
  /// @pre drives().
  std::unique_ptr<DrivingStrategy> driving_strategy(const Maze& maze, const Briefing& briefing) const;
};

/// The SPEC of a mouse, whether or not its user gave it a name.
/// @param mouse any.
/// @return a part of the mouse.
inline const std::string& spec_of(const Contestant& mouse) { return mouse.spec.empty() ? mouse.name : mouse.spec; }

/// Warnings for the user: what external mice could do without a sandbox, and what they could remember with one.
/// @param mice all mice of a race.
/// @return lines that end in a line feed; empty if there is nothing to warn of.
std::string freedom_note(const std::vector<Contestant>& mice);

/// Gives a mouse another name, which its trained versions keep. Its SPEC stays.
/// @param mouse to be changed.
/// @param name used in results, as given.
void rename(Contestant& mouse, const std::string& name);

/// Either mice, or the reason why the text is not a SPEC.
struct SpecResult {
  std::vector<Contestant> contestants;  ///< empty if there is an error
  std::string error;                    ///< one line for the user; empty on success
  /// All errors of a mice file, one line each with its place; `error` is the first of them.
  std::vector<std::string> problems = {};
};

/// Whether external mice run in sandboxes. With `always`, a system without sandboxes refuses them.
enum class SandboxUse { where_possible, always, never };

/// Packages installed for the Pythons of external mice. Cached for a race, because the query starts each Python.
struct InstalledPackages {
  std::mutex mutex;                                       ///< of `known`
  std::map<std::vector<std::string>, std::string> known;  ///< by the mouse's variables and the path of Python
};

/// How external mice are started.
struct ExternalOptions {
  std::string python;     ///< for capstone robots; empty: python3 in PATH
  std::string board;      ///< of firmware: a file or a built-in name; empty: the usual one
  std::string label;      ///< version label that replaces the hash of their files in stores of contests; empty: hash
  std::string directory;  ///< working directory of commands; empty: the current one
  bool owns_directory = true;  ///< whether `directory`, if set, is the mouse's own folder
  /// From a mice file, for one external mouse: the interpreter that runs its command, further arguments, and
  /// environment variables as NAME=VALUE.
  std::string interpreter;
  std::vector<std::string> arguments, environment;
  ExternalLimits limits;
  SandboxUse sandbox = SandboxUse::where_possible;
  bool keep_folder = false;  ///< see Launch::keeps_folder
  /// Files hidden from them, a list shared by copies of these options. A race adds its mazes.
  std::shared_ptr<HiddenFiles> hidden = std::make_shared<HiddenFiles>();
  std::shared_ptr<InstalledPackages> packages = std::make_shared<InstalledPackages>();  ///< shared by copies, too
  int runs = 1;                             ///< contests of each external mouse in each maze
  const std::atomic<bool>* stop = nullptr;  ///< if true, external mice are terminated; may be null
};

}  // namespace labmouse
