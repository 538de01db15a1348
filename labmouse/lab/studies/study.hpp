// Compares mice by cross-validation: each maze is held out once, and a learning mouse has learned only from the other
// folds. See docs/explanation/statistics-and-bounds.md for the results.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/standings/mouse_pair.hpp"
#include "labmouse/lab/studies/folds.hpp"

namespace labmouse {

/// The settings of a study.
struct StudyOrder {
  /// The race in each fold. Its seed also assigns the folds.
  RaceOrder race;
  int folds = 5;
  /// Whether learning mice are trained anew for each fold; if not, they race with what they have learned before.
  bool learning = true;
};

/// The results of a study; of a stopped one, those of its complete folds.
struct Study {
  StudyOrder order;
  std::vector<std::string> mice;        ///< their names, in the order given
  std::vector<std::string> learners;    ///< those of them that can learn, in the same order
  MazeSelection selection;              ///< of the mazes given
  std::vector<std::size_t> fold_sizes;  ///< mazes in each fold, done or not
  int folds_done = 0;
  Race race;                 ///< all held-out contests, of the folds that were done
  std::vector<int> fold_of;  ///< of each maze in `race`, 0 to folds - 1
  std::string error;         ///< why these mazes allow no study; then nothing was raced
};

/// Callbacks of a study.
struct StudyHooks {
  /// Called after each contest with the number of all contests; from any thread, but one at a time.
  std::function<void(std::size_t all)> finished;
  /// Read before each lesson and each contest. Once it is true, no other begins, and the unfinished fold is left out.
  const std::atomic<bool>* stop = nullptr;
};

/// Races the mice on each fold of the mazes. Needs at least one mouse (names must differ), two folds, and as many mazes
/// as folds after select_mazes(). A mouse that does not learn gets the same scores as in a race with the same seeds.
Study hold_study(const std::vector<Contestant>& mice, std::vector<NamedMaze> mazes, const StudyOrder& order,
                 const StudyHooks& hooks = {});

/// The position in the race of the mouse with that name, which must exist.
std::size_t position_of(const Race& race, const std::string& mouse);

/// The comparison of two mice (positions in Study::race) on the same mazes.
struct Comparison {
  std::size_t mouse = 0;
  std::size_t against = 0;
  MousePair pair;
  PairVerdicts verdicts;  ///< corrected for all comparisons of the study
};

/// Up to this number, all pairs of mice are compared; beyond it, each mouse only with the first one.
inline constexpr std::size_t most_in_all_pairs = 4;

/// Compares later mice with earlier ones in the order given: (2,1), (3,1), (3,2), ...; of too many only (2,1), (3,1),
/// ...
std::vector<Comparison> comparisons_of(const Study& study);

std::vector<MousePair> pairs_of(const std::vector<Comparison>& comparisons);

/// Standings and comparisons for a terminal, with notes below.
std::string table_of(const Study& study, bool colours);

/// CSV: a header, and a line for each maze with its fold, its bound and the mean score of each mouse.
std::string csv_of(const Study& study);

/// JSON: the object of a race with additional keys. `skipped` are the files that are no mazes.
std::string json_of(const Study& study, const std::vector<SkippedFile>& skipped);

/// An SVG picture: for each comparison (or for a single mouse) the sorted differences, and the scores against the
/// bound.
std::string picture_of(const Study& study);

}  // namespace labmouse
