// Many mice on many mazes, in any world.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "labmouse/lab/races/contest_store.hpp"
#include "labmouse/lab/races/world.hpp"

namespace labmouse {

/// One of several parts of a race that together are all of it, and share no contest.
struct Shard {
  std::size_t number = 1;  ///< 1 to `of`
  std::size_t of = 1;
};

struct RaceOrder {
  std::shared_ptr<const World> world;
  /// Contests in each maze where the mouse or the world is stochastic; others need one.
  int runs = 20;
  std::uint64_t seed = 1;
  /// Threads; 0 takes as many as there are processors. Results do not depend on it.
  int jobs = 0;
  /// Only these contests are run, and listed.
  Shard shard = {};
  /// Where contests are taken from and kept; may be null.
  std::shared_ptr<ContestStore> store = nullptr;
  /// Files and folders to hide from external mice besides the mazes themselves, because they contain mazes: the store,
  /// the records.
  std::vector<std::string> files = {};
  /// If set, an external mouse gets another seed in each maze: that of this number for the first maze, and so on.
  /// Otherwise it gets the same one in all.
  std::optional<std::uint64_t> first_told = std::nullopt;
};

/// One contest and how it went. `mouse` and `maze` are positions in the race's lists.
struct ContestResult {
  std::size_t mouse = 0;
  std::size_t maze = 0;
  int run = 0;
  std::uint64_t seed = 0;
  std::uint64_t told = 0;  ///< the seed that an external mouse gets
  bool done = false;       ///< false where the race was stopped before
  /// False where the machine was too busy to judge an external mouse: the contest counts nowhere and is not kept.
  bool judged = true;
  std::string outcome;  ///< "finished", "forfeit: hit a wall"
  /// Why an external mouse's program did not get as far as its first word; empty where it did, and for all other mice.
  std::string never_started;
  int outcome_order = 0;  ///< position of the outcome in lists of outcomes
  /// In the world's own unit; lower is better. Nothing where the contest has none.
  std::optional<double> score;
  /// What enters the mean over all contests: the score, or what the world counts for a failure, if anything.
  std::optional<double> counted;
  std::optional<double> ratio;  ///< score over the maze's bound, as the world compares them
  /// The world's own; null until the contest is done.
  std::shared_ptr<const Figures> figures;
};

/// The figures of a contest that is done, in the world that has this struct of them.
template <class Struct>
const Struct& figures_of(const ContestResult& contest) {
  return static_cast<const Struct&>(*contest.figures);
}

struct Race {
  RaceOrder order;
  std::vector<Contestant> mice;        ///< in the order of their names
  std::vector<NamedMaze> mazes;        ///< in the order of their names
  std::vector<MazeFacts> facts;        ///< of each maze
  std::vector<ContestResult> results;  ///< by mouse, maze and run
  bool stopped = false;                ///< before all contests were done

  const World& world() const { return *order.world; }
};

/// What a race tells while it goes on.
struct RaceHooks {
  /// What is to be kept of a contest, for `finished`; asked from any thread. Nothing, where it is empty.
  std::function<Keep(const ContestResult&)> keep;
  /// Called after each contest, from any thread but never from two at once. A contest from the store does not run
  /// again; then the last argument is empty.
  std::function<void(const Race&, const ContestResult&, const ContestOutput&)> finished;
  /// Asked before each contest and each decision; once it is true no other begins.
  const std::atomic<bool>* stop = nullptr;
};

/// Races every contestant on every maze. The world must refuse none of them.
Race hold_race(std::vector<Contestant> mice, std::vector<NamedMaze> mazes, const RaceOrder& order,
               const RaceHooks& hooks = {});

/// How many contests such a race has.
std::size_t contests_of(const std::vector<Contestant>& mice, std::size_t mazes, const RaceOrder& order);

/// The seed of a contest: from the race's seed, the maze's name without its folders, and the number of the run.
std::uint64_t contest_seed(std::uint64_t seed, std::string_view maze_name, int run);

/// The seed that an external mouse gets: from the race's seed and the number of the run alone, so that it says
/// nothing of the maze.
std::uint64_t seed_of_program(std::uint64_t seed, int run);

/// Marks a result as not judged, and removes its score and everything else that would enter a mean.
void leave_unjudged(ContestResult& result);

/// Whether a contest enters the means: it is done and judged, and some mouse could score in its maze.
bool counts(const Race& race, const ContestResult& contest);

/// The contest without times by the clock, so that equal contests make equal files.
ContestResult without_clock(ContestResult contest, const WorldFields& fields);

/// The figure of that name of a contest, as JSON has it; std::monostate where there is none.
Value figure_of(const Race& race, const ContestResult& contest, std::string_view key);

}  // namespace labmouse
