#include <fmt/format.h>

#include <array>

#include "labmouse/lab/drive/drive_figures.hpp"
#include "labmouse/lab/drive/world_fields.hpp"
#include "labmouse/lab/standings/common_fields.hpp"
#include "labmouse/lab/standings/mouse_figures.hpp"

namespace labmouse {
namespace {
namespace seconds_table {

using F = SecondsFigure;
using M = DriveMazeFigure;
using fields::figure;

constexpr std::array<ContestField, 14> contest_fields = {{{"maze", fields::maze_name},
                                                          {"seed", fields::seed},
                                                          {"outcome", fields::outcome},
                                                          {"score", figure<F::score>},
                                                          {"search_us", figure<F::search>},
                                                          {"best_us", figure<F::best>},
                                                          {"excess", figure<F::excess>},
                                                          {"proven", figure<F::proven>},
                                                          {"starts", figure<F::starts>},
                                                          {"decisions", figure<F::decisions>},
                                                          {"replanned", figure<F::replanned>},
                                                          {discovered_share, figure<F::discovered>},
                                                          {visited_share, figure<F::visited>},
                                                          {said_last, figure<F::words>}}};

constexpr std::array<ContestField, 14> csv_fields = {{{"mouse", fields::mouse_name},
                                                      {"maze", fields::maze_name},
                                                      {"seed", fields::seed},
                                                      {"outcome", fields::outcome},
                                                      {"score_us", figure<F::score_us>},
                                                      {"gate_to_gate_us", figure<F::gate_to_gate>},
                                                      {"rest_to_centre_us", figure<F::rest_to_centre>},
                                                      {"search_us", figure<F::search>},
                                                      {"best_us", figure<F::best>},
                                                      {"fastest_us", fields::of_maze<M::fastest>},
                                                      {"bound_us", fields::of_maze<M::bound>},
                                                      {"proven", figure<F::proven>},
                                                      {"starts", figure<F::starts>},
                                                      {"decisions", figure<F::decisions>}}};

constexpr std::array<MazeField, 5> maze_fields = {{{"name", fields::name},
                                                   {"width", fields::width},
                                                   {"height", fields::height},
                                                   {"fastest_us", fields::maze_figure<M::fastest>},
                                                   {"bound_us", fields::maze_figure<M::bound>}}};

Value figure_at(const ContestResult& contest, F figure) { return contest.figures[static_cast<std::size_t>(figure)]; }

/// The mean over the contests with a score, a time of it in seconds.
std::optional<double> mean_seconds(const Race& race, const Standing& standing, F figure) {
  std::vector<double> values;
  for_each_solved(race, standing, [&](const ContestResult& contest) {
    if (const auto time = number_of(figure_at(contest, figure))) values.push_back(*time / 1e6);
  });
  return mean_if_any(values);
}

/// Contests whose best run is a fastest possible one.
int optimal(const Race& race, const Standing& standing) {
  int count = 0;
  for_each_solved(race, standing, [&](const ContestResult& contest) {
    const auto fastest = number_of(race.facts[contest.maze].figures[static_cast<std::size_t>(M::fastest)]);
    const auto best = number_of(figure_at(contest, F::best));
    if (fastest && best && *best <= *fastest) ++count;
  });
  return count;
}

/// Contests in which the mouse knew that no faster route could exist.
int proven(const Race& race, const Standing& standing) {
  int count = 0;
  for_each_solved(race, standing, [&](const ContestResult& contest) {
    if (number_of(figure_at(contest, F::proven)) == 1.0) ++count;
  });
  return count;
}

template <F Figure>
Value mean_time(const Race& race, const Standing& standing) {
  return or_none(mean_seconds(race, standing, Figure));
}
template <F Figure>
Value sum(const Race& race, const Standing& standing) {
  std::int64_t all = 0;
  for_each_counted(race, standing, [&](const ContestResult& contest) {
    all += static_cast<std::int64_t>(number_of(figure_at(contest, Figure)).value_or(0.0));
  });
  return all;
}

constexpr std::array<MouseField, 17> mouse_fields = {
    {{"name", fields::name},
     {"parameters", fields::parameters},
     {"scored", fields::solved},
     {"runs", fields::runs},
     {"mean_score", fields::mean_all},
     {"interval", fields::interval},
     {"mean_ratio", fields::mean_ratio},
     {"mean_search", mean_time<F::search>},
     {"mean_best", mean_time<F::best>},
     {"mean_excess", [](const Race& r, const Standing& s) -> Value { return or_none(mean_solved(r, s, "excess")); }},
     {"mean_starts", [](const Race& r, const Standing& s) -> Value { return or_none(mean_solved(r, s, "starts")); }},
     {"optimal", [](const Race& r, const Standing& s) -> Value { return std::int64_t{optimal(r, s)}; }},
     {"proven", [](const Race& r, const Standing& s) -> Value { return std::int64_t{proven(r, s)}; }},
     {"decisions", sum<F::decisions>},
     {"replanned", sum<F::replanned>},
     {"mean_discovered_share",
      [](const Race& r, const Standing& s) -> Value { return or_none(mean_of_all(r, s, discovered_share)); }},
     {"mean_visited_share",
      [](const Race& r, const Standing& s) -> Value { return or_none(mean_of_all(r, s, visited_share)); }}}};

std::string above_best(const Race& race, const Standing& standing) {
  const auto excess = mean_solved(race, standing, "excess");
  return columns::number(excess ? std::optional(100.0 * *excess) : std::nullopt, 2);
}

constexpr std::array<Column, 10> table = {
    {{"", "scored", 8, columns::solved},
     {"score", "s", 7, columns::mean_all},
     {"95 %", "interval", 13, [](const Race&, const Standing& s) { return columns::interval(s, 2); }},
     {"score", "/bound", 6, columns::mean_ratio},
     {"search", "s", 7,
      [](const Race& r, const Standing& s) { return columns::number(mean_seconds(r, s, F::search), 1); }},
     {"best", "run s", 7,
      [](const Race& r, const Standing& s) { return columns::number(mean_seconds(r, s, F::best), 3); }},
     {"above", "best%", 6, above_best},
     {"best", "runs", 5, [](const Race& r, const Standing& s) { return fmt::format("{}", optimal(r, s)); }},
     {"", "proven", 6, [](const Race& r, const Standing& s) { return fmt::format("{}", proven(r, s)); }},
     {"runs", "each", 4,
      [](const Race& r, const Standing& s) { return columns::number(mean_solved(r, s, "starts"), 1); }}}};

constexpr std::array<ComparedFigure, 2> compared = {{{"search_us", "search"}, {"best_us", "best run"}}};

}  // namespace seconds_table
}  // namespace

const WorldFields& seconds_fields() {
  static constexpr WorldFields all = {seconds_table::contest_fields, seconds_table::csv_fields,
                                      seconds_table::mouse_fields,   seconds_table::maze_fields,
                                      seconds_table::table,          seconds_table::compared};
  return all;
}

}  // namespace labmouse
