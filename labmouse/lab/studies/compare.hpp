// Which mouse is better? Runs pairs of contests, maze by maze, until a sequential test decides.
//
// Compared is the share of the best possible score: 1 divided by the ratio of the score to the bound of the maze, as
// the world compares them; 0 for a contest that is not finished, and never above 1. It makes mazes of different size
// comparable. A maze does not count in which a score has no such ratio.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/studies/sequential_test.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/maze/generators/generator.hpp"

namespace labmouse {

/// Where the mazes come from: drawn at random from a list, with repetitions, or, without one, generated.
struct MazeSource {
  std::vector<NamedMaze> list;
  const Generator* generator = &contest_generator;
  GeneratorOrder order = {};  ///< its seed is not used
};

/// The maze of that number, from 0. Equal numbers and seeds give equal mazes with equal names.
NamedMaze drawn_maze(const MazeSource& source, std::uint64_t seed, std::size_t number);

/// The number of the first maze of those that are raced in together with the maze of that number.
std::size_t batch_with(std::size_t number);
/// The same for the name of a drawn maze.
std::size_t batch_of(std::string_view name);

/// The most pairs of contests with a candidate.
inline constexpr std::size_t most_pairs = 1'000'000;

struct CompareOrder {
  RaceOrder race;  ///< its `runs` and `shard` are not used
  MazeSource mazes;
  SequentialOrder test;
  std::size_t most = 5000;  ///< at most so many mazes are drawn, 1 to `most_pairs`
};

/// A mouse that is compared with the first one. Both race in the same mazes with the same seeds.
struct ComparedMouse {
  std::string mouse;
  SequentialVerdict verdict = SequentialVerdict::undecided;
  std::size_t pairs = 0;                  ///< of contests that were compared
  double share = 0.0, first_share = 0.0;  ///< mean shares of the best possible score, of it and of the first mouse
  double difference = 0.0;                ///< of these two; above 0 is better
  /// Of the difference, as SequentialTest has it; of an exact difference both ends are the difference.
  Interval interval = {-1.0, 1.0};
};

struct Compared {
  CompareOrder order;
  std::string first;                      ///< the mouse that the others are compared with
  std::vector<ComparedMouse> candidates;  ///< in the order given
  std::size_t mazes = 0;                  ///< raced in
  std::size_t skipped = 0;  ///< of them, those that no mouse can score in, or in which a contest was not judged
  /// Whether these are all contests that there are: the mazes are a list, and neither mice nor world are stochastic.
  /// Then each maze of the list was raced in once, and the sign of the difference decides.
  bool exact = false;
  bool stopped = false;
  std::string never_started;  ///< a line for each program that never started, which ends the comparison
};

struct CompareHooks {
  /// Called now and then, with all that is known so far.
  std::function<void(const Compared&)> advanced;
  /// Read before each contest; once it is true, no other begins.
  const std::atomic<bool>* stop = nullptr;
  /// Read after each race: whether the store lacks contests, which are to run elsewhere. Then the comparison stops. It
  /// looks ahead at as many mazes as it has raced in, so that the store knows what it may need next.
  std::function<bool()> lacks_contests = {};
};

/// The alpha and beta of each candidate: those of the order divided by the number of candidates (Bonferroni), so that
/// they hold for all candidates together.
SequentialOrder order_of_each(const SequentialOrder& order, std::size_t candidates);

/// Compares all mice but the first with the first. A candidate that is decided races no more.
/// @param mice two or more with different names, none of which the world refuses.
Compared hold_comparison(std::vector<Contestant> mice, const CompareOrder& order, const CompareHooks& hooks = {});

/// In one maze: the share of the best possible score of each mouse, in the order of the mice. Nothing where the maze
/// does not count for that mouse, or the mouse did not race.
using MazeShares = std::vector<std::optional<double>>;

/// A part of a comparison, for one of several machines: the contests of one batch.
struct BatchOrder {
  /// The number of the first maze of the batch, as of batch_of().
  std::size_t begin = 0;
  /// Read before each contest; once it is true, no other begins, and the result is empty.
  const std::atomic<bool>* stop = nullptr;
};

/// Runs the contests of one batch. Of an exact comparison all mazes are one batch.
/// @param mice those of the comparison that are not decided; all others have no shares.
/// @returns the shares of each maze, in the order of drawing.
std::vector<MazeShares> shares_of_batch(std::vector<Contestant> mice, const CompareOrder& order,
                                        const BatchOrder& part);

/// Compares mice by shares that are there already, of one batch after the other.
/// @param mice as for hold_comparison().
/// @param order that of the batches.
Compared judged(std::vector<Contestant> mice, const CompareOrder& order, const std::vector<MazeShares>& shares);

/// Whether a comparison needs no more contests: all candidates are decided, all mazes are used, or none counts.
bool is_over(const Compared& compared);

/// A line for each candidate, and what the verdicts mean.
std::string table_of(const Compared& compared);

/// docs/reference/results.md lists its fields.
Json comparison_json(const Compared& compared);
/// The same as text.
std::string json_of(const Compared& compared);

}  // namespace labmouse
