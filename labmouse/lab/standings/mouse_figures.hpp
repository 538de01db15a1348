// Means and counts over the contests of one mouse, for worlds to make their own figures of.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/standings/standing.hpp"

namespace labmouse {

/// The mean, or nothing where there is nothing to take it of.
std::optional<double> mean_if_any(std::span<const double> values);

/// The mean of a figure over the contests with a score, or over all that count. Contests without the figure are left
/// out.
std::optional<double> mean_finished(const Race& race, const Standing& standing, std::string_view figure);
std::optional<double> mean_of_all(const Race& race, const Standing& standing, std::string_view figure);

/// Calls with each contest of the mouse that counts, or that has a score.
template <class Call>
void for_each_counted(const Race& race, const Standing& standing, Call call) {
  for (const ContestResult& contest : race.results)
    if (contest.mouse == standing.mouse && counts(race, contest)) call(contest);
}
template <class Call>
void for_each_finished(const Race& race, const Standing& standing, Call call) {
  for_each_counted(race, standing, [&](const ContestResult& contest) {
    if (contest.score) call(contest);
  });
}

}  // namespace labmouse
