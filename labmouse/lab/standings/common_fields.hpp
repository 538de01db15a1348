// The fields of contests, mice and mazes that most worlds have, for their lists.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/standings/standing.hpp"

namespace labmouse::fields {

// Of a contest.
Value mouse_name(const Race& race, const ContestResult& contest);
Value maze_name(const Race& race, const ContestResult& contest);
Value seed(const Race& race, const ContestResult& contest);
Value outcome(const Race& race, const ContestResult& contest);
Value score(const Race& race, const ContestResult& contest);
Value ratio(const Race& race, const ContestResult& contest);
/// The figure that is that member of the world's struct.
template <auto Member>
Value figure(const Race&, const ContestResult& contest) {
  return value_of(figures_of<decltype(struct_of(Member))>(contest).*Member);
}
/// The same field of the contest's maze.
template <Value (*Field)(const Race&, std::size_t)>
Value of_maze(const Race& race, const ContestResult& contest) {
  return Field(race, contest.maze);
}

// Of a mouse.
Value name(const Race& race, const Standing& standing);
Value parameters(const Race& race, const Standing& standing);
Value contestant(const Race& race, const Standing& standing);
Value finished(const Race& race, const Standing& standing);
Value runs(const Race& race, const Standing& standing);
Value mean_all(const Race& race, const Standing& standing);
Value mean_finished(const Race& race, const Standing& standing);
Value interval(const Race& race, const Standing& standing);
Value mean_ratio(const Race& race, const Standing& standing);
Value mean_share(const Race& race, const Standing& standing);
Value share_interval(const Race& race, const Standing& standing);
/// Both.
inline constexpr std::array<MouseField, 2> share_fields = {
    {{"share_of_best", mean_share}, {"share_interval", share_interval}}};

// Of a maze.
Value name(const Race& race, std::size_t maze);
Value width(const Race& race, std::size_t maze);
Value height(const Race& race, std::size_t maze);
Value bound(const Race& race, std::size_t maze);
/// The fastest possible run, as a number; and as a whole number, for worlds in which it is one.
Value best_run(const Race& race, std::size_t maze);
Value whole_best_run(const Race& race, std::size_t maze);

}  // namespace labmouse::fields

namespace labmouse::columns {

/// Both lines of a heading as one.
std::string heading(std::string_view first, std::string_view second);

/// A number with so many digits behind the point, or "-".
std::string number(const std::optional<double>& value, int digits);

/// "12/15": contests with a score of all.
std::string finished(const Race& race, const Standing& standing);
std::string mean_all(const Race& race, const Standing& standing);
std::string mean_finished(const Race& race, const Standing& standing);
std::string mean_ratio(const Race& race, const Standing& standing);
std::string mean_share(const Race& race, const Standing& standing);
std::string share_interval(const Race& race, const Standing& standing);
/// Both, as percentages.
inline constexpr std::array<Column, 2> share_columns = {
    {{.first = "share of",
      .second = "best, %",
      .width = 8,
      .text = mean_share,
      .key = "share_of_best",
      .meaning = "Mean share of the best possible score over all contests, in percent: the best possible score of the "
                 "maze divided by the mouse's; 0 for a contest without a score.",
      .digits = 1,
      .higher_is_better = true,
      .factor = 100.0,
      .rare = true},
     {.first = "95 % of",
      .second = "share",
      .width = 9,
      .text = share_interval,
      .key = "share_interval",
      .meaning = "95 % interval of the share of the best possible score over the mazes, in percent.",
      .digits = 1,
      .higher_is_better = true,
      .factor = 100.0,
      .rare = true}}};
/// "38.1-39.4" with so many digits, "-" without a mean or with fewer than two mazes.
std::string interval(const Standing& standing, int digits);

}  // namespace labmouse::columns
