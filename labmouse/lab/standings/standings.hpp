// What a race says of each mouse.
#pragma once

#include <optional>
#include <vector>

#include "labmouse/lab/races/race.hpp"
#include "labmouse/lab/standings/standing.hpp"

namespace labmouse {

/// The bounded score of a contest: the best possible score of its maze divided by its score, at most 1; 0 without a
/// score. Nothing where the contest does not count, or where scores have no ratio, as those that are not positive.
std::optional<double> share_of_best(const Race& race, const ContestResult& contest);

/// The standings, best mean over all first. If failed contests count nothing, mice are first ordered by their
/// number of finished contests. Ties are broken by the world's tie breaker, then by name.
std::vector<Standing> standings_of(const Race& race);

/// An interval of scores without the part that no score is in.
Interval among_scores(const Interval& interval, const ScorePlace& place);

/// A mouse's mean in each maze (by position) of what its contests count, where it has one.
std::vector<std::optional<double>> scores_by_maze(const Race& race, std::size_t mouse);

/// The figure of that name of a mouse, as JSON has it; std::monostate where there is none.
Value figure_of(const Race& race, const Standing& standing, std::string_view key);

}  // namespace labmouse
