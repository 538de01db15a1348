#include "labmouse/lab/mms/mms_fields.hpp"

#include <fmt/format.h>

#include <array>

#include "labmouse/external/mms/run.hpp"
#include "labmouse/lab/mms/mms_figures.hpp"
#include "labmouse/lab/standings/common_fields.hpp"
#include "labmouse/lab/standings/mouse_figures.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {
namespace {

using F = MmsFigures;
using fields::figure;

constexpr StoredFigures stored = stored_figures<F, &F::outcome, &F::end, &F::finished, &F::score, &F::best_run,
                                                &F::run_ratio, &F::statistics, &F::total, &F::lines, &F::invalid_lines,
                                                &F::log, &F::errors, &F::simulated_seconds, &F::seconds, &F::visited>;

constexpr std::array<ContestField, 18> contest_fields = {
    {{"maze", fields::maze_name},
     {"outcome", figure<&F::outcome>},
     {"end", figure<&F::end>},
     {"finished", figure<&F::finished>},
     {"score", figure<&F::score>},
     {"possible_score", fields::of_maze<fields::bound>},
     {"ratio", fields::ratio},
     {"best_run", figure<&F::best_run>},
     {"possible_run", fields::of_maze<fields::best_run>},
     {"run_ratio", figure<&F::run_ratio>},
     {"statistics", figure<&F::statistics>},
     {"lines", figure<&F::lines>},
     {"invalid_lines", figure<&F::invalid_lines>},
     {"log", figure<&F::log>},
     {"errors", figure<&F::errors>},
     {"simulated_seconds", figure<&F::simulated_seconds>},
     {.key = "seconds", .of = figure<&F::seconds>, .by_clock = true},
     {visited_share, figure<&F::visited>}}};

/// One value of `getStat`, by its place among them.
template <std::size_t Place>
Value statistic(const Race&, const ContestResult& contest) {
  const auto json = ReadJson::parse(figures_of<F>(contest).statistics.text);
  return fmt::format("{}", json[std::string(mms_statistics[Place].name)].get<float>());
}

template <auto Figure>
Value milliseconds(const Race&, const ContestResult& contest) {
  return fmt::format("{:.3f}", *number_of(value_of(figures_of<F>(contest).*Figure)));
}

constexpr std::array<ContestField, 22> csv_fields = {{{"mouse", fields::mouse_name},
                                                      {"maze", fields::maze_name},
                                                      {"outcome", figure<&F::outcome>},
                                                      {"end", figure<&F::end>},
                                                      {"finished", figure<&F::finished>},
                                                      {"best_run", figure<&F::best_run>},
                                                      {"possible_run", fields::of_maze<fields::best_run>},
                                                      {"possible_score", fields::of_maze<fields::bound>},
                                                      {mms_statistics[0].name, statistic<0>},
                                                      {mms_statistics[1].name, statistic<1>},
                                                      {mms_statistics[2].name, statistic<2>},
                                                      {mms_statistics[3].name, statistic<3>},
                                                      {mms_statistics[4].name, statistic<4>},
                                                      {mms_statistics[5].name, statistic<5>},
                                                      {mms_statistics[6].name, statistic<6>},
                                                      {mms_statistics[7].name, statistic<7>},
                                                      {mms_statistics[8].name, statistic<8>},
                                                      {mms_statistics[9].name, statistic<9>},
                                                      {"lines", figure<&F::lines>},
                                                      {"invalid_lines", figure<&F::invalid_lines>},
                                                      {"simulated_seconds", milliseconds<&F::simulated_seconds>},
                                                      {"seconds", milliseconds<&F::seconds>}}};

constexpr std::array<MazeField, 5> maze_fields = {{{"name", fields::name},
                                                   {"width", fields::width},
                                                   {"height", fields::height},
                                                   {"best_run", fields::best_run},
                                                   {"best_score", fields::bound}}};

std::optional<double> mean_total(const Race& race, const Standing& standing) {
  std::vector<double> values;
  for_each_counted(race, standing,
                   [&](const ContestResult& contest) { values.push_back(figures_of<F>(contest).total); });
  return mean_if_any(values);
}

/// The sum of a figure over all runs, including those in mazes without a route to the centre.
template <std::int64_t F::*Figure>
Value sum(const Race& race, const Standing& standing) {
  std::int64_t all = 0;
  for (const ContestResult& contest : race.results)
    if (contest.mouse == standing.mouse && contest.done) all += figures_of<F>(contest).*Figure;
  return all;
}

/// The number of runs with each outcome that occurred.
Value outcomes(const Race& race, const Standing& standing) {
  auto json = Json::object();
  for (std::size_t outcome = 0; outcome <= static_cast<std::size_t>(MmsOutcome::interrupted); ++outcome) {
    const std::string name(name_of(static_cast<MmsOutcome>(outcome)));
    int count = 0;
    for (const ContestResult& contest : race.results)
      if (contest.mouse == standing.mouse && contest.done && figures_of<F>(contest).outcome == name) ++count;
    if (count > 0) json[name] = count;
  }
  return JsonText{json.dump()};
}

constexpr std::array<MouseField, 15> own_mouse_fields = {
    {{"name", fields::name},
     {"finished", fields::finished},
     {"runs", fields::runs},
     {"mean_score", fields::mean_all},
     {"interval", fields::interval},
     {"mean_finished_score", fields::mean_finished},
     {"mean_ratio", fields::mean_ratio},
     {"mean_best_run",
      [](const Race& r, const Standing& s) -> Value { return value_of(mean_finished(r, s, "best_run")); }},
     {"mean_run_ratio",
      [](const Race& r, const Standing& s) -> Value { return value_of(mean_finished(r, s, "run_ratio")); }},
     {"mean_total", [](const Race& r, const Standing& s) -> Value { return value_of(mean_total(r, s)); }},
     {"mean_seconds", [](const Race& r, const Standing& s) -> Value { return value_of(mean_of_all(r, s, "seconds")); }},
     {"lines", sum<&F::lines>},
     {"invalid_lines", sum<&F::invalid_lines>},
     {"outcomes", outcomes},
     {"mean_visited_share",
      [](const Race& r, const Standing& s) -> Value { return value_of(mean_of_all(r, s, visited_share)); }}}};
constexpr auto mouse_fields = joined(own_mouse_fields, fields::share_fields);

/// With as many digits as its column has room for.
std::string interval(const Race&, const Standing& standing) {
  return columns::interval(standing, standing.interval.high >= 1000 ? 0 : 1);
}

constexpr std::array<Column, 9> own_columns = {
    {{.first = "", .second = "finished", .width = 8, .text = columns::finished},
     {.first = "mean",
      .second = "score",
      .width = 6,
      .text = [](const Race&, const Standing& s) { return columns::number(s.mean_all, 1); },
      .key = "mean_score",
      .meaning = "Mean score of mms over all runs; an unfinished one counts 2000, as in mms.",
      .digits = 3},
     {.first = "95 %", .second = "interval", .width = 11, .text = interval},
     {.first = "score of",
      .second = "finished",
      .width = 8,
      .text = [](const Race&, const Standing& s) { return columns::number(s.mean_finished, 1); },
      .key = "mean_finished_score",
      .meaning = "Mean score of mms over the finished runs.",
      .digits = 1,
      .rare = true},
     {.first = "score /",
      .second = "best",
      .width = 7,
      .text = [](const Race&, const Standing& s) { return columns::number(s.mean_ratio, 2); }},
     {.first = "best",
      .second = "run",
      .width = 6,
      .text = [](const Race& r, const Standing& s) { return columns::number(mean_finished(r, s, "best_run"), 1); },
      .key = "mean_best_run",
      .meaning = "Mean of the best runs from start to goal, in steps of mms.",
      .digits = 1},
     {.first = "run /",
      .second = "best",
      .width = 6,
      .text = [](const Race& r, const Standing& s) { return columns::number(mean_finished(r, s, "run_ratio"), 2); },
      .key = "mean_run_ratio",
      .meaning = "Mean over the finished runs of the best run divided by the best possible one in that maze.",
      .digits = 2},
     {.first = "",
      .second = "total",
      .width = 6,
      .text = [](const Race& r, const Standing& s) { return columns::number(mean_total(r, s), 0); },
      .key = "mean_total",
      .meaning = "Mean effective distance and turns of all that the mouse did in a run.",
      .rare = true},
     {.first = "s per",
      .second = "run",
      .width = 6,
      .text = [](const Race& r, const Standing& s) { return columns::number(mean_of_all(r, s, "seconds"), 2); },
      .key = "mean_seconds",
      .meaning = "Mean time that a run took here, in seconds.",
      .digits = 2,
      .rare = true}}};
constexpr auto all_columns = joined(own_columns, columns::share_columns);

}  // namespace

const WorldFields& mms_fields() {
  static constexpr WorldFields all = {.contest = contest_fields,
                                      .csv = csv_fields,
                                      .mouse = mouse_fields,
                                      .maze = maze_fields,
                                      .columns = all_columns,
                                      .figures = stored,
                                      .bound = "best_score"};
  return all;
}

}  // namespace labmouse
