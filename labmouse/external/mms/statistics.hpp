// The statistics and the score of the mms simulator.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace labmouse {

/// All values of `getStat`. Distances in half steps, as 32-bit floating-point numbers, as in mms.
struct MmsStatistics {
  float total_distance = 0, total_effective_distance = 0, total_turns = 0;
  float current_run_distance = 0, current_run_effective_distance = 0, current_run_turns = 0;
  /// -1 until a run was finished.
  float best_run_distance = -1, best_run_effective_distance = -1, best_run_turns = -1;
  /// 2000 until a run was finished; then best effective distance + best turns + a tenth of the totals.
  float score = 2000;
  bool finished = false;

  friend constexpr bool operator==(const MmsStatistics&, const MmsStatistics&) = default;
};

/// One value of `getStat`.
struct MmsStatistic {
  std::string_view name;  ///< as `getStat` takes it
  float MmsStatistics::*value;
  bool whole;  ///< mms replies it as a whole number
};

/// All of them.
inline constexpr std::array<MmsStatistic, 10> mms_statistics = {{
    {"total-distance", &MmsStatistics::total_distance, true},
    {"total-effective-distance", &MmsStatistics::total_effective_distance, false},
    {"total-turns", &MmsStatistics::total_turns, true},
    {"current-run-distance", &MmsStatistics::current_run_distance, true},
    {"current-run-effective-distance", &MmsStatistics::current_run_effective_distance, false},
    {"current-run-turns", &MmsStatistics::current_run_turns, true},
    {"best-run-distance", &MmsStatistics::best_run_distance, true},
    {"best-run-effective-distance", &MmsStatistics::best_run_effective_distance, false},
    {"best-run-turns", &MmsStatistics::best_run_turns, true},
    {"score", &MmsStatistics::score, false},
}};

/// The valid names for getStat.
std::span<const std::string_view> statistic_names();

/// A value of `getStat NAME` as mms replies it (C's %g); nullopt for an unknown name. Distances and turns are whole
/// numbers; -1 from a million on, where mms would print no whole number.
std::optional<std::string> statistic_reply(const MmsStatistics& statistics, std::string_view name);

/// Effective distance of a move of so many half steps (as asked for): above 2, half of them plus 1.
constexpr float effective_distance(std::int64_t half_steps) {
  const auto distance = static_cast<float>(half_steps);
  return half_steps <= 2 ? distance : distance / 2 + 1;
}

/// Updates the statistics. A run begins with a move from the start cell, and ends in a goal or back in the start cell.
class MmsLedger {
 public:
  /// Added by ackReset to the effective distance of the next run, and to the total. Several in a row count once.
  static constexpr float reset_penalty = 15;

  /// Counts a move that was begun, by the half steps asked for, even if the mouse does not get that far.
  void count_move(std::int64_t half_steps, bool from_start_cell);
  /// A turn by 45 or by 90 degrees.
  void count_turn();
  /// The end of a move or a turn, in such a cell.
  void count_arrival(bool in_goal, bool in_start_cell);
  /// An ackReset.
  void count_reset();

  const MmsStatistics& statistics() const { return statistics_; }
  /// The statistics at the end of the best run; the present ones if none was finished.
  const MmsStatistics& at_best_run() const { return statistics_.finished ? at_best_run_ : statistics_; }
  /// Whether a run was begun and is not over.
  bool in_run() const { return in_run_; }
  /// Effective distance with which the next run begins.
  float pending_penalty() const { return pending_penalty_; }

 private:
  void begin_run();
  void finish_run();
  void update_score();

  MmsStatistics statistics_, at_best_run_;
  bool in_run_ = false;
  float pending_penalty_ = 0;
};

}  // namespace labmouse
