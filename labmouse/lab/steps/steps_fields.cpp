#include "labmouse/lab/steps/steps_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "labmouse/lab/standings/common_fields.hpp"
#include "labmouse/lab/standings/mouse_figures.hpp"
#include "labmouse/lab/steps/steps_figures.hpp"

namespace labmouse {
namespace {

using F = StepsFigures;
using fields::figure;

double microseconds_per_decision(const ContestResult& contest) {
  const auto& figures = figures_of<F>(contest);
  return figures.microseconds.number / std::max(1.0, static_cast<double>(figures.decisions));
}

Value microseconds(const Race&, const ContestResult& contest) { return microseconds_per_decision(contest); }
Value rounded_microseconds(const Race&, const ContestResult& contest) {
  return JsonText{fmt::format("{:.3f}", microseconds_per_decision(contest))};
}

constexpr StoredFigures stored =
    stored_figures<F, &F::search_steps, &F::speed_steps, &F::discovered, &F::visited, &F::blocked_steps,
                   &F::void_rotations, &F::cut_movements, &F::idle_resets, &F::first_action_error, &F::words,
                   &F::counts, &F::decisions, &F::microseconds>;

constexpr std::array<ContestField, 15> contest_fields = {
    {{"maze", fields::maze_name},
     {"seed", fields::seed},
     {"outcome", fields::outcome},
     {"score", fields::score},
     {"search_steps", figure<&F::search_steps>},
     {"speed_steps", figure<&F::speed_steps>},
     {discovered_share, figure<&F::discovered>},
     {visited_share, figure<&F::visited>},
     {.key = "microseconds_per_decision", .of = microseconds, .by_clock = true},
     {"blocked_steps", figure<&F::blocked_steps>},
     {"void_rotations", figure<&F::void_rotations>},
     {"cut_movements", figure<&F::cut_movements>},
     {"idle_resets", figure<&F::idle_resets>},
     {said_last, figure<&F::words>},
     {"counts", figure<&F::counts>}}};

constexpr std::array<ContestField, 12> csv_fields = {{{"mouse", fields::mouse_name},
                                                      {"maze", fields::maze_name},
                                                      {"seed", fields::seed},
                                                      {"outcome", fields::outcome},
                                                      {"score", fields::score},
                                                      {"search_steps", figure<&F::search_steps>},
                                                      {"speed_steps", figure<&F::speed_steps>},
                                                      {"optimum", fields::of_maze<fields::whole_best_run>},
                                                      {"bound", fields::of_maze<fields::bound>},
                                                      {"microseconds_per_decision", rounded_microseconds},
                                                      {discovered_share, figure<&F::discovered>},
                                                      {visited_share, figure<&F::visited>}}};

constexpr std::array<MazeField, 5> maze_fields = {{{"name", fields::name},
                                                   {"width", fields::width},
                                                   {"height", fields::height},
                                                   {"optimum", fields::whole_best_run},
                                                   {"bound", fields::bound}}};

/// Steps of a finished contest's speed run above the shortest one.
double over_optimum(const Race& race, const ContestResult& contest) {
  return static_cast<double>(*figures_of<F>(contest).speed_steps) - *race.facts[contest.maze].best_run;
}

std::optional<double> mean_over_optimum(const Race& race, const Standing& standing) {
  std::vector<double> values;
  for_each_finished(race, standing,
                    [&](const ContestResult& contest) { values.push_back(over_optimum(race, contest)); });
  return mean_if_any(values);
}

/// Share of all contests whose speed run was a shortest one.
double optimal_share(const Race& race, const Standing& standing) {
  int optimal = 0;
  for_each_finished(race, standing,
                    [&](const ContestResult& contest) { optimal += over_optimum(race, contest) == 0.0 ? 1 : 0; });
  return standing.runs > 0 ? optimal / static_cast<double>(standing.runs) : 0.0;
}

double microseconds_per_decision(const Race& race, const Standing& standing) {
  double spent = 0.0, decisions = 0.0;
  for_each_counted(race, standing, [&](const ContestResult& contest) {
    spent += figures_of<F>(contest).microseconds.number;
    decisions += static_cast<double>(figures_of<F>(contest).decisions);
  });
  return decisions > 0 ? spent / decisions : 0.0;
}

constexpr std::array<MouseField, 15> own_mouse_fields = {
    {{"name", fields::name},
     {"parameters", fields::parameters},
     {"contestant", fields::contestant},
     {"finished", fields::finished},
     {"runs", fields::runs},
     {"mean_score", fields::mean_finished},
     {"mean_par1", fields::mean_all},
     {"interval", fields::interval},
     {"mean_ratio", fields::mean_ratio},
     {"mean_search_steps",
      [](const Race& r, const Standing& s) -> Value { return value_of(mean_finished(r, s, "search_steps")); }},
     {"mean_speed_over_optimum",
      [](const Race& r, const Standing& s) -> Value { return value_of(mean_over_optimum(r, s)); }},
     {"optimal_share", [](const Race& r, const Standing& s) -> Value { return optimal_share(r, s); }},
     {"mean_discovered_share",
      [](const Race& r, const Standing& s) -> Value { return value_of(mean_of_all(r, s, discovered_share)); }},
     {"mean_visited_share",
      [](const Race& r, const Standing& s) -> Value { return value_of(mean_of_all(r, s, visited_share)); }},
     {"microseconds_per_decision",
      [](const Race& r, const Standing& s) -> Value { return microseconds_per_decision(r, s); }}}};
constexpr auto mouse_fields = joined(own_mouse_fields, fields::share_fields);

std::string best_runs(const Race& race, const Standing& standing) {
  return standing.runs > 0 ? fmt::format("{:.1f}", 100.0 * optimal_share(race, standing)) : "-";
}

std::string us_a_step(const Race& race, const Standing& standing) {
  const double microseconds = microseconds_per_decision(race, standing);
  return standing.runs > 0 ? fmt::format("{:.{}f}", microseconds, microseconds < 100.0 ? 2 : 0) : "-";
}

// With the built-in mice a line fits into 90 columns.
constexpr std::array<Column, 9> own_columns = {
    {{.first = "", .second = "finished", .width = 8, .text = columns::finished},
     {.first = "mean",
      .second = "score",
      .width = 7,
      .text = columns::mean_all,
      .key = "mean_par1",
      .meaning = "Mean score over all contests, in steps: speed run plus a thirtieth of the search run; a failed one "
                 "counts 100.",
      .digits = 3},
     {.first = "95 %",
      .second = "interval",
      .width = 11,
      .text = [](const Race&, const Standing& s) { return columns::interval(s, 1); }},
     {.first = "score of",
      .second = "finished",
      .width = 8,
      .text = columns::mean_finished,
      .key = "mean_score",
      .meaning = "Mean score over the finished contests, in steps.",
      .digits = 3,
      .rare = true},
     {.first = "score /", .second = "best", .width = 7, .text = columns::mean_ratio},
     {.first = "search",
      .second = "steps",
      .width = 6,
      .text = [](const Race& r, const Standing& s) { return columns::number(mean_finished(r, s, "search_steps"), 1); },
      .key = "mean_search_steps",
      .meaning = "Mean search steps of the finished contests, including the reset.",
      .digits = 1},
     {.first = "speed run",
      .second = "excess",
      .width = 9,
      .text = [](const Race& r, const Standing& s) { return columns::number(mean_over_optimum(r, s), 2); },
      .key = "mean_speed_over_optimum",
      .meaning = "Mean steps by which the speed runs of the finished contests were longer than the shortest run of "
                 "their maze.",
      .digits = 2},
     {.first = "shortest",
      .second = "runs, %",
      .width = 8,
      .text = best_runs,
      .key = "optimal_share",
      .meaning = "Percentage of all contests whose speed run was a shortest one.",
      .digits = 1,
      .higher_is_better = true,
      .factor = 100.0,
      .rare = true},
     {.first = "µs per",
      .second = "step",
      .width = 6,
      .text = us_a_step,
      .key = "microseconds_per_decision",
      .meaning = "Mean time per decision, in microseconds: the only figure that changes from race to race.",
      .digits = 2,
      .rare = true}}};
constexpr auto all_columns = joined(own_columns, columns::share_columns);

}  // namespace

const WorldFields& steps_fields() {
  static constexpr WorldFields all = {.contest = contest_fields,
                                      .csv = csv_fields,
                                      .mouse = mouse_fields,
                                      .maze = maze_fields,
                                      .columns = all_columns,
                                      .figures = stored,
                                      .bound_meaning = "best possible score, that of a mouse that knows the maze"};
  return all;
}

}  // namespace labmouse
