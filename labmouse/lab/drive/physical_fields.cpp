#include <fmt/format.h>

#include <array>

#include "labmouse/lab/drive/drive_figures.hpp"
#include "labmouse/lab/drive/world_fields.hpp"
#include "labmouse/lab/numbers/interval.hpp"
#include "labmouse/lab/standings/common_fields.hpp"
#include "labmouse/lab/standings/mouse_figures.hpp"

namespace labmouse {
namespace {
namespace physical_table {

using F = PhysicalFigure;
using M = DriveMazeFigure;
using fields::figure;

constexpr std::array<ContestField, 26> contest_fields = {{{"maze", fields::maze_name},
                                                          {"seed", fields::seed},
                                                          {"outcome", fields::outcome},
                                                          {"score", figure<F::score>},
                                                          {"search_us", figure<F::search>},
                                                          {"best_us", figure<F::best>},
                                                          {"excess", figure<F::excess>},
                                                          {"starts", figure<F::starts>},
                                                          {"done", figure<F::done>},
                                                          {"slid", figure<F::slid>},
                                                          {"strayed", figure<F::strayed>},
                                                          {"misread", figure<F::misread>},
                                                          {"walled_in", figure<F::walled_in>},
                                                          {"late", figure<F::late>},
                                                          {"carried", figure<F::carried>},
                                                          {"grazes", figure<F::grazes>},
                                                          {"misreads", figure<F::misreads>},
                                                          {"contradictions", figure<F::contradictions>},
                                                          {"frailty", figure<F::frailty>},
                                                          {"penalised", figure<F::penalised>},
                                                          {"decisions", figure<F::decisions>},
                                                          {"replanned", figure<F::replanned>},
                                                          {discovered_share, figure<F::discovered>},
                                                          {visited_share, figure<F::visited>},
                                                          {"ended_by", figure<F::ended_by>},
                                                          {said_last, figure<F::words>}}};

constexpr std::array<ContestField, 23> csv_fields = {{{"mouse", fields::mouse_name},
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
                                                      {"starts", figure<F::starts>},
                                                      {"done", figure<F::done>},
                                                      {"slid", figure<F::slid>},
                                                      {"strayed", figure<F::strayed>},
                                                      {"misread", figure<F::misread>},
                                                      {"walled_in", figure<F::walled_in>},
                                                      {"late", figure<F::late>},
                                                      {"carried", figure<F::carried>},
                                                      {"misreads", figure<F::misreads>},
                                                      {"frailty", figure<F::frailty>},
                                                      {"penalised", figure<F::penalised>},
                                                      {"ended_by", figure<F::ended_by>}}};

constexpr std::array<MazeField, 5> maze_fields = {{{"name", fields::name},
                                                   {"width", fields::width},
                                                   {"height", fields::height},
                                                   {"fastest_us", fields::maze_figure<M::fastest>},
                                                   {"bound_us", fields::maze_figure<M::bound>}}};

Value figure_at(const ContestResult& contest, F figure) { return contest.figures[static_cast<std::size_t>(figure)]; }

/// Over all contests; nothing where it is unknown of all of them.
std::optional<double> sum(const Race& race, const Standing& standing, F figure) {
  double all = 0.0;
  bool known = standing.runs == 0;
  for_each_counted(race, standing, [&](const ContestResult& contest) {
    const auto number = number_of(figure_at(contest, figure));
    known = known || number;
    all += number.value_or(0.0);
  });
  return known ? std::optional(all) : std::nullopt;
}
template <F Figure>
Value count(const Race& race, const Standing& standing) {
  const auto all = sum(race, standing, Figure);
  return all ? Value(static_cast<std::int64_t>(*all)) : Value(nullptr);
}

/// The mean over the contests with a score, a time of it in seconds.
template <F Figure>
std::optional<double> mean_seconds(const Race& race, const Standing& standing) {
  std::vector<double> values;
  for_each_solved(race, standing, [&](const ContestResult& contest) {
    if (const auto time = number_of(figure_at(contest, Figure))) values.push_back(*time / 1e6);
  });
  return mean_if_any(values);
}

std::optional<double> penalised(const Race& race, const Standing& standing) {
  const auto all = sum(race, standing, F::penalised);
  return standing.runs == 0 || !all ? std::nullopt : std::optional(*all / standing.runs);
}

Value interval_value(const Interval& interval) { return JsonText{fmt::format("[{},{}]", interval.low, interval.high)}; }

constexpr std::array<MouseField, 24> mouse_fields = {
    {{"name", fields::name},
     {"parameters", fields::parameters},
     {"scored", fields::solved},
     {"runs", fields::runs},
     {"finished_interval", [](const Race&, const Standing& s) { return interval_value(s.finished); }},
     {"mean_score", fields::mean_all},
     {"interval", fields::interval},
     {"mean_ratio", fields::mean_ratio},
     {"penalised", [](const Race& r, const Standing& s) -> Value { return or_none(penalised(r, s)); }},
     {"mean_search", [](const Race& r, const Standing& s) -> Value { return or_none(mean_seconds<F::search>(r, s)); }},
     {"mean_best", [](const Race& r, const Standing& s) -> Value { return or_none(mean_seconds<F::best>(r, s)); }},
     {"mean_excess", [](const Race& r, const Standing& s) -> Value { return or_none(mean_solved(r, s, "excess")); }},
     {"starts", count<F::starts>},
     {"done", count<F::done>},
     {"slid", count<F::slid>},
     {"strayed", count<F::strayed>},
     {"misread", count<F::misread>},
     {"walled_in", count<F::walled_in>},
     {"late", count<F::late>},
     {"carried", count<F::carried>},
     {"misreads", count<F::misreads>},
     {"contradictions", count<F::contradictions>},
     {"mean_discovered_share",
      [](const Race& r, const Standing& s) -> Value { return or_none(mean_of_all(r, s, discovered_share)); }},
     {"mean_visited_share",
      [](const Race& r, const Standing& s) -> Value { return or_none(mean_of_all(r, s, visited_share)); }}}};

template <F Figure>
std::string count_text(const Race& race, const Standing& standing) {
  return columns::number(sum(race, standing, Figure), 0);
}

std::string finished_text(const Race&, const Standing& standing) {
  const Interval& interval = standing.finished;
  return standing.runs == 0 ? "-" : fmt::format("{:.0f}-{:.0f}", 100.0 * interval.low, 100.0 * interval.high);
}

constexpr std::array<Column, 13> table = {
    {{"", "scored", 8, columns::solved},
     {"95 %", "of 100", 7, finished_text},
     {"score", "s", 7, columns::mean_all},
     {"penal-", "ised", 7, [](const Race& r, const Standing& s) { return columns::number(penalised(r, s), 3); }},
     {"search", "s", 7,
      [](const Race& r, const Standing& s) { return columns::number(mean_seconds<F::search>(r, s), 1); }},
     {"best", "run s", 7,
      [](const Race& r, const Standing& s) { return columns::number(mean_seconds<F::best>(r, s), 3); }},
     {"", "runs", 5, count_text<F::starts>},
     {"", "slid", 5, count_text<F::slid>},
     {"", "strayed", 8, count_text<F::strayed>},
     {"mis-", "read", 5, count_text<F::misread>},
     {"walled", "in", 6, count_text<F::walled_in>},
     {"", "late", 5, count_text<F::late>},
     {"misread", "walls", 7, count_text<F::misreads>}}};

}  // namespace physical_table
}  // namespace

const WorldFields& physical_fields() {
  static constexpr WorldFields all = {physical_table::contest_fields, physical_table::csv_fields,
                                      physical_table::mouse_fields, physical_table::maze_fields, physical_table::table};
  return all;
}

}  // namespace labmouse
