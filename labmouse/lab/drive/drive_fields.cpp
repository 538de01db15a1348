#include "labmouse/lab/drive/drive_fields.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "labmouse/lab/drive/drive_figures.hpp"
#include "labmouse/lab/numbers/interval.hpp"
#include "labmouse/lab/standings/common_fields.hpp"
#include "labmouse/lab/standings/mouse_figures.hpp"

namespace labmouse {
namespace {

using D = DriveFigures;
using S = SecondsFigures;
using P = PhysicalFigures;
using fields::figure;

/// The best possible score in whole microseconds.
Value bound_us(const Race& race, std::size_t maze) {
  const auto& bound = race.facts[maze].bound;
  return bound ? Value(std::llround(*bound * 1e6)) : Value(nullptr);
}

// What the worlds share.

constexpr std::array<ContestField, 7> result_fields = {{{"maze", fields::maze_name},
                                                        {"seed", fields::seed},
                                                        {"outcome", fields::outcome},
                                                        {"score", figure<&D::score>},
                                                        {"search_us", figure<&D::search>},
                                                        {"best_us", figure<&D::best>},
                                                        {"excess", figure<&D::excess>}}};

constexpr std::array<ContestField, 4> search_fields = {{{"decisions", figure<&D::decisions>},
                                                        {"replanned", figure<&D::replanned>},
                                                        {discovered_share, figure<&D::discovered>},
                                                        {visited_share, figure<&D::visited>}}};

constexpr std::array<ContestField, 11> time_fields = {{{"mouse", fields::mouse_name},
                                                       {"maze", fields::maze_name},
                                                       {"seed", fields::seed},
                                                       {"outcome", fields::outcome},
                                                       {"score_us", figure<&D::score_us>},
                                                       {"gate_to_gate_us", figure<&D::gate_to_gate>},
                                                       {"rest_to_centre_us", figure<&D::rest_to_centre>},
                                                       {"search_us", figure<&D::search>},
                                                       {"best_us", figure<&D::best>},
                                                       {"fastest_us", fields::of_maze<fields::whole_best_run>},
                                                       {"bound_us", fields::of_maze<bound_us>}}};

constexpr std::array<MazeField, 5> maze_fields = {{{"name", fields::name},
                                                   {"width", fields::width},
                                                   {"height", fields::height},
                                                   {"fastest_us", fields::whole_best_run},
                                                   {"bound_us", bound_us}}};

/// The mean, in seconds, of a time over the contests with a score.
template <auto Figure>
std::optional<double> mean_seconds(const Race& race, const Standing& standing) {
  std::vector<double> values;
  for_each_finished(race, standing, [&](const ContestResult& contest) {
    if (const auto time = number_of(figure<Figure>(race, contest))) values.push_back(*time / 1e6);
  });
  return mean_if_any(values);
}
template <auto Figure>
Value mean_time(const Race& race, const Standing& standing) {
  return value_of(mean_seconds<Figure>(race, standing));
}

/// The sum of a figure over all contests; nothing if no contest has the figure.
template <auto Figure>
std::optional<double> sum(const Race& race, const Standing& standing) {
  double all = 0.0;
  bool known = standing.runs == 0;
  for_each_counted(race, standing, [&](const ContestResult& contest) {
    const auto number = number_of(figure<Figure>(race, contest));
    known = known || number;
    all += number.value_or(0.0);
  });
  return known ? std::optional(all) : std::nullopt;
}
template <auto Figure>
Value count(const Race& race, const Standing& standing) {
  const auto all = sum<Figure>(race, standing);
  return all ? Value(static_cast<std::int64_t>(*all)) : Value(nullptr);
}
template <auto Figure>
std::string count_text(const Race& race, const Standing& standing) {
  return columns::number(sum<Figure>(race, standing), 0);
}

constexpr std::array<MouseField, 4> mouse_fields = {{{"name", fields::name},
                                                     {"parameters", fields::parameters},
                                                     {"finished", fields::finished},
                                                     {"runs", fields::runs}}};
constexpr std::array<MouseField, 3> score_means = {
    {{"mean_score", fields::mean_all}, {"interval", fields::interval}, {"mean_ratio", fields::mean_ratio}}};
constexpr std::array<MouseField, 3> time_means = {
    {{"mean_search", mean_time<&D::search>},
     {"mean_best", mean_time<&D::best>},
     {"mean_excess", [](const Race& r, const Standing& s) { return value_of(mean_finished(r, s, "excess")); }}}};
constexpr std::array<MouseField, 2> share_means = {
    {{"mean_discovered_share",
      [](const Race& r, const Standing& s) { return value_of(mean_of_all(r, s, discovered_share)); }},
     {"mean_visited_share",
      [](const Race& r, const Standing& s) { return value_of(mean_of_all(r, s, visited_share)); }}}};

constexpr Column scored_column = {.first = "", .second = "finished", .width = 8, .text = columns::finished};
constexpr Column score_column = {.first = "score,",
                                 .second = "",
                                 .width = 7,
                                 .text = columns::mean_all,
                                 .key = "mean_score",
                                 .meaning = "Mean score over the contests that have one: seconds, or marks lost.",
                                 .digits = 3,
                                 .in_unit = true};
constexpr std::array<Column, 2> time_columns = {
    {{.first = "search",
      .second = "run, s",
      .width = 7,
      .text = [](const Race& r, const Standing& s) { return columns::number(mean_seconds<&D::search>(r, s), 1); },
      .key = "mean_search",
      .meaning = "Mean time of the contests until the first speed run began, in seconds.",
      .digits = 1},
     {.first = "best",
      .second = "run, s",
      .width = 7,
      .text = [](const Race& r, const Standing& s) { return columns::number(mean_seconds<&D::best>(r, s), 3); },
      .key = "mean_best",
      .meaning = "Mean time of the best runs from rest at the start to the goal, or of the best laps, in seconds.",
      .digits = 3}}};

// The world without errors.

/// Contests whose best run is a fastest possible one.
std::int64_t optimal(const Race& race, const Standing& standing) {
  std::int64_t count = 0;
  for_each_finished(race, standing, [&](const ContestResult& contest) {
    const auto& fastest = race.facts[contest.maze].best_run;
    const auto& best = figures_of<S>(contest).best;
    if (fastest && best && static_cast<double>(*best) <= *fastest) ++count;
  });
  return count;
}

/// Contests in which the mouse knew that no faster route could exist.
std::int64_t proven(const Race& race, const Standing& standing) {
  std::int64_t count = 0;
  for_each_finished(race, standing, [&](const ContestResult& contest) {
    if (figures_of<S>(contest).proven) ++count;
  });
  return count;
}

std::string above_best(const Race& race, const Standing& standing) {
  const auto excess = mean_finished(race, standing, "excess");
  return columns::number(excess ? std::optional(100.0 * *excess) : std::nullopt, 2);
}

constexpr auto seconds_contest =
    joined(result_fields, std::array<ContestField, 2>{{{"proven", figure<&S::proven>}, {"starts", figure<&S::starts>}}},
           search_fields, std::array<ContestField, 1>{{{said_last, figure<&S::words>}}});
constexpr auto seconds_csv = joined(time_fields, std::array<ContestField, 3>{{{"proven", figure<&S::proven>},
                                                                              {"starts", figure<&S::starts>},
                                                                              {"decisions", figure<&S::decisions>}}});
constexpr auto seconds_mouse = joined(
    mouse_fields, score_means, time_means,
    std::array<MouseField, 5>{
        {{"mean_starts", [](const Race& r, const Standing& s) { return value_of(mean_finished(r, s, "starts")); }},
         {"optimal", [](const Race& r, const Standing& s) -> Value { return optimal(r, s); }},
         {"proven", [](const Race& r, const Standing& s) -> Value { return proven(r, s); }},
         {"decisions", count<&S::decisions>},
         {"replanned", count<&S::replanned>}}},
    share_means, fields::share_fields);
constexpr auto seconds_table = joined(
    std::array<Column, 4>{{scored_column,
                           score_column,
                           {.first = "95 %",
                            .second = "interval",
                            .width = 13,
                            .text = [](const Race&, const Standing& s) { return columns::interval(s, 2); }},
                           {.first = "score /", .second = "best", .width = 7, .text = columns::mean_ratio}}},
    time_columns,
    std::array<Column, 4>{
        {{.first = "excess",
          .second = "%",
          .width = 6,
          .text = above_best,
          .key = "mean_excess",
          .meaning = "How much longer the routes of the best runs take than the fastest route, in percent.",
          .digits = 2,
          .factor = 100.0},
         {.first = "fastest",
          .second = "routes",
          .width = 7,
          .text = [](const Race& r, const Standing& s) { return fmt::format("{}", optimal(r, s)); },
          .key = "optimal",
          .meaning = "Contests whose best run took the fastest route.",
          .higher_is_better = true,
          .rare = true},
         {.first = "",
          .second = "proven",
          .width = 6,
          .text = [](const Race& r, const Standing& s) { return fmt::format("{}", proven(r, s)); },
          .key = "proven",
          .meaning = "Contests in which the mouse knew that no route could be faster.",
          .higher_is_better = true,
          .rare = true},
         {.first = "runs per",
          .second = "contest",
          .width = 8,
          .text = [](const Race& r, const Standing& s) { return columns::number(mean_finished(r, s, "starts"), 1); },
          .key = "mean_starts",
          .meaning = "Mean number of starts in a contest.",
          .digits = 1}}},
    columns::share_columns);
constexpr std::array<ComparedFigure, 2> seconds_compared = {{{"search_us", "search"}, {"best_us", "best run"}}};

// The worlds with errors.

std::optional<double> mean_par1(const Race& race, const Standing& standing) {
  const auto all = sum<&P::par1>(race, standing);
  return standing.runs == 0 || !all ? std::nullopt : std::optional(*all / standing.runs);
}

Value finished_share(const Race&, const Standing& standing) {
  return JsonText{fmt::format("[{},{}]", standing.finished_share.low, standing.finished_share.high)};
}

std::string finished_text(const Race&, const Standing& standing) {
  const Interval& interval = standing.finished_share;
  return standing.runs == 0 ? "-" : fmt::format("{:.0f}-{:.0f}", 100.0 * interval.low, 100.0 * interval.high);
}

constexpr std::array<ContestField, 8> run_fields = {{{"starts", figure<&P::starts>},
                                                     {"done", figure<&P::done>},
                                                     {"slid", figure<&P::slid>},
                                                     {"position_lost", figure<&P::position_lost>},
                                                     {"wall_error", figure<&P::wall_error>},
                                                     {"no_route_left", figure<&P::no_route_left>},
                                                     {"late", figure<&P::late>},
                                                     {"carried", figure<&P::carried>}}};
constexpr auto physical_contest = joined(
    result_fields, run_fields,
    std::array<ContestField, 5>{{{"grazes", figure<&P::grazes>},
                                 {"wrong_walls", figure<&P::wrong_walls>},
                                 {"contradictions", figure<&P::contradictions>},
                                 {"severity", figure<&P::severity>},
                                 {"par1", figure<&P::par1>}}},
    search_fields, std::array<ContestField, 2>{{{"ended_by", figure<&P::ended_by>}, {said_last, figure<&P::words>}}});
constexpr auto physical_csv = joined(time_fields, run_fields,
                                     std::array<ContestField, 4>{{{"wrong_walls", figure<&P::wrong_walls>},
                                                                  {"severity", figure<&P::severity>},
                                                                  {"par1", figure<&P::par1>},
                                                                  {"ended_by", figure<&P::ended_by>}}});
constexpr auto physical_mouse =
    joined(mouse_fields, std::array<MouseField, 1>{{{"finished_interval", finished_share}}}, score_means,
           std::array<MouseField, 1>{
               {{"mean_par1", [](const Race& r, const Standing& s) { return value_of(mean_par1(r, s)); }}}},
           time_means,
           std::array<MouseField, 10>{{{"starts", count<&P::starts>},
                                       {"done", count<&P::done>},
                                       {"slid", count<&P::slid>},
                                       {"position_lost", count<&P::position_lost>},
                                       {"wall_error", count<&P::wall_error>},
                                       {"no_route_left", count<&P::no_route_left>},
                                       {"late", count<&P::late>},
                                       {"carried", count<&P::carried>},
                                       {"wrong_walls", count<&P::wrong_walls>},
                                       {"contradictions", count<&P::contradictions>}}},
           share_means, fields::share_fields);
constexpr auto physical_table = joined(
    std::array<Column, 4>{
        {scored_column,
         {.first = "95 %",
          .second = "range, %",
          .width = 8,
          .text = finished_text,
          .key = "finished_interval",
          .meaning = "Share of the contests that ended with a score, in percent: 95 % interval over the mazes.",
          .higher_is_better = true,
          .factor = 100.0},
         score_column,
         {.first = "failures",
          .second = "at limit",
          .width = 8,
          .text = [](const Race& r, const Standing& s) { return columns::number(mean_par1(r, s), 3); },
          .key = "mean_par1",
          .meaning = "Mean score over all contests, in seconds or marks lost; one without a score counts the time "
                     "limit, or all marks.",
          .digits = 3}}},
    time_columns,
    std::array<Column, 7>{
        {{.first = "",
          .second = "runs",
          .width = 5,
          .text = count_text<&P::starts>,
          .key = "starts",
          .meaning = "Runs that began at the start, search runs among them."},
         {.first = "tyres",
          .second = "slipped",
          .width = 7,
          .text = count_text<&P::slid>,
          .key = "slid",
          .meaning = "Runs that ended in a crash because the tyres slipped."},
         {.first = "lost",
          .second = "position",
          .width = 8,
          .text = count_text<&P::position_lost>,
          .key = "position_lost",
          .meaning = "Runs that ended in a crash because the mouse had lost its position."},
         {.first = "wall",
          .second = "errors",
          .width = 6,
          .text = count_text<&P::wall_error>,
          .key = "wall_error",
          .meaning = "Runs that ended in a crash into a wall that the map had as open."},
         {.first = "no route",
          .second = "left",
          .width = 8,
          .text = count_text<&P::no_route_left>,
          .key = "no_route_left",
          .meaning = "Runs that ended because the map had no route left, or contradicted what the mouse saw."},
         {.first = "time",
          .second = "limit",
          .width = 5,
          .text = count_text<&P::late>,
          .key = "late",
          .meaning = "Runs that the time limit cut short."},
         {.first = "wrong",
          .second = "walls",
          .width = 5,
          .text = count_text<&P::wrong_walls>,
          .key = "wrong_walls",
          .meaning = "Walls that the mouse took for closed where they are open, or for open where they are closed.",
          .rare = true}}},
    columns::share_columns);

// Do not change the order: existing stores have the figures in this order.

constexpr StoredFigures seconds_stored =
    stored_figures<S, &S::score, &S::search, &S::best, &S::excess, &S::proven, &S::starts, &S::decisions, &S::replanned,
                   &S::discovered, &S::visited, &S::words, &S::score_us, &S::gate_to_gate, &S::rest_to_centre>;
constexpr StoredFigures physical_stored =
    stored_figures<P, &P::score, &P::search, &P::best, &P::excess, &P::starts, &P::done, &P::slid, &P::position_lost,
                   &P::wall_error, &P::no_route_left, &P::late, &P::carried, &P::grazes, &P::wrong_walls,
                   &P::contradictions, &P::severity, &P::par1, &P::decisions, &P::replanned, &P::discovered,
                   &P::visited, &P::ended_by, &P::words, &P::score_us, &P::gate_to_gate, &P::rest_to_centre>;

}  // namespace

const WorldFields& seconds_fields() {
  static constexpr WorldFields all = {
      .contest = seconds_contest,
      .csv = seconds_csv,
      .mouse = seconds_mouse,
      .maze = maze_fields,
      .columns = seconds_table,
      .figures = seconds_stored,
      .compared = seconds_compared,
      .bound = "bound_us",
      .bound_meaning = "best possible score, that of the fastest route, driven at once"};
  return all;
}

const WorldFields& physical_fields() {
  static constexpr WorldFields all = {
      .contest = physical_contest,
      .csv = physical_csv,
      .mouse = physical_mouse,
      .maze = maze_fields,
      .columns = physical_table,
      .figures = physical_stored,
      .bound = "bound_us",
      .bound_meaning = "best possible score, that of a mouse that never errs and knows the maze"};
  return all;
}

}  // namespace labmouse
