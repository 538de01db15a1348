// An honest comparison of mice: each maze is held out once, and a mouse that learns has learned from the others only.
// docs/explanation/statistics-and-bounds.md describes the results.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/standings/mouse_pair.hpp"
#include "labmouse/lab/studies/folds.hpp"

namespace labmouse {

struct StudyOrder {
  /// Its seed also deals the folds.
  RaceOrder race;
  int folds = 5;
  /// Whether mice that learn are taught anew for each fold; without, they race with what they bring along.
  bool learning = true;
};

/// What a study found. Where it was stopped, of the folds that were done.
struct Study {
  StudyOrder order;
  std::vector<std::string> mice;        ///< their names, in the order given
  std::vector<std::string> learners;    ///< those of them that can learn, in the same order
  MazeSelection selection;              ///< of the mazes given
  std::vector<std::size_t> fold_sizes;  ///< mazes in each fold, done or not
  int folds_done = 0;
  Race race;                 ///< all held-out contests, of the folds that were done
  std::vector<int> fold_of;  ///< of each maze in `race`, 0 to folds - 1
  std::string error;         ///< why there can be no study of these mazes; then nothing was raced
};

/// What a study tells while it goes on.
struct StudyHooks {
  /// Called after each contest with the number of all, from any thread but never from two at once.
  std::function<void(std::size_t all)> finished;
  /// Asked before each lesson and each contest; once it is true no other begins, and the fold that was under way is
  /// left out.
  const std::atomic<bool>* stop = nullptr;
};

/// Races the mice (at least one, names differ) on each fold of the mazes. Takes at least two folds and as many mazes,
/// see select_mazes. A mouse that does not learn gets the scores of a race, with the same seeds.
Study hold_study(const std::vector<Contestant>& mice, std::vector<NamedMaze> mazes, const StudyOrder& order,
                 const StudyHooks& hooks = {});

/// The position of the mouse of that name in the race, in which it has to be.
std::size_t position_of(const Race& race, const std::string& mouse);

/// Two mice (positions in Study::race) on the same mazes.
struct Comparison {
  std::size_t mouse = 0;
  std::size_t against = 0;
  MousePair pair;
  PairVerdicts verdicts;  ///< corrected for all comparisons of the study
};

/// So many mice are compared each with each; of more, each with the first one only.
inline constexpr std::size_t most_in_all_pairs = 4;

/// Later mice against earlier ones in the order given: (2,1), (3,1), (3,2), ...; of too many only (2,1), (3,1), ...
std::vector<Comparison> comparisons_of(const Study& study);

std::vector<MousePair> pairs_of(const std::vector<Comparison>& comparisons);

/// Standings and comparisons for a terminal, with notes below.
std::string table_of(const Study& study, bool colours);

/// One line a maze with its fold, its bound and the mean score of each mouse, with a header.
std::string csv_of(const Study& study);

/// Everything as one JSON object: that of a race, and more; `skipped` are the files that were no mazes.
std::string json_of(const Study& study, const std::vector<SkippedFile>& skipped);

/// For each comparison (of one mouse alone: for it) the sorted differences and the scores against the bound, as an SVG
/// picture.
std::string picture_of(const Study& study);

}  // namespace labmouse
