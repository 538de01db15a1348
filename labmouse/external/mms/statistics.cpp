#include "labmouse/external/mms/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace labmouse {
namespace {

constexpr auto names = [] {
  std::array<std::string_view, mms_statistics.size()> all;
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = mms_statistics[i].name;
  return all;
}();

/// From here on, %g writes a whole number with an exponent.
constexpr float first_with_exponent = 1e6F;

}  // namespace

std::span<const std::string_view> statistic_names() { return names; }

std::optional<std::string> statistic_reply(const MmsStatistics& statistics, std::string_view name) {
  const auto* found = std::find_if(mms_statistics.begin(), mms_statistics.end(),
                                   [&](const MmsStatistic& statistic) { return statistic.name == name; });
  if (found == mms_statistics.end()) return std::nullopt;
  const float value = statistics.*found->value;
  return found->whole && value >= first_with_exponent ? "-1" : fmt::format("{:g}", value);
}

void MmsLedger::count_move(std::int64_t half_steps, bool from_start_cell) {
  if (from_start_cell) begin_run();
  const auto distance = static_cast<float>(half_steps);
  const float effective = effective_distance(half_steps);
  statistics_.total_distance += distance;
  statistics_.total_effective_distance += effective;
  if (in_run_) {
    statistics_.current_run_distance += distance;
    statistics_.current_run_effective_distance += effective;
  }
  update_score();
}

void MmsLedger::begin_run() {
  in_run_ = true;
  statistics_.current_run_distance = 0;
  statistics_.current_run_turns = 0;
  statistics_.current_run_effective_distance = pending_penalty_;
  statistics_.total_effective_distance += pending_penalty_;
  pending_penalty_ = 0;
}

void MmsLedger::count_turn() {
  ++statistics_.total_turns;
  if (in_run_) ++statistics_.current_run_turns;
  update_score();
}

void MmsLedger::count_arrival(bool in_goal, bool in_start_cell) {
  if (in_goal) {
    finish_run();
  } else if (in_start_cell) {
    in_run_ = false;
  }
}

void MmsLedger::finish_run() {
  // Later moves in the goal come here again: they change nothing, because the run is over and nothing was added to it.
  in_run_ = false;
  MmsStatistics& all = statistics_;
  const float run = all.current_run_turns + all.current_run_effective_distance;
  const bool is_best = !all.finished || run < all.best_run_turns + all.best_run_effective_distance;
  if (is_best) {
    all.best_run_distance = all.current_run_distance;
    all.best_run_effective_distance = all.current_run_effective_distance;
    all.best_run_turns = all.current_run_turns;
  }
  all.finished = true;
  update_score();
  if (is_best) at_best_run_ = all;
}

void MmsLedger::count_reset() {
  in_run_ = false;
  pending_penalty_ = reset_penalty;
}

void MmsLedger::update_score() {
  if (!statistics_.finished) return;
  const float best = statistics_.best_run_effective_distance + statistics_.best_run_turns;
  const float total = statistics_.total_effective_distance + statistics_.total_turns;
  statistics_.score = static_cast<float>(best + 0.1 * total);
}

}  // namespace labmouse
