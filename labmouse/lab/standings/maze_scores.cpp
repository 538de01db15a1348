#include "labmouse/lab/standings/maze_scores.hpp"

namespace labmouse {

void MazeScores::add(std::optional<double> score, double counted) {
  ++contests;
  sum += counted;
  if (!score) return;
  ++finished;
  finished_sum += *score;
}

std::optional<double> MazeScores::mean() const { return contests > 0 ? std::optional(sum / contests) : std::nullopt; }

std::optional<double> MazeScores::finished_mean() const {
  return finished > 0 ? std::optional(finished_sum / finished) : std::nullopt;
}

std::optional<double> MazeScores::failed_share() const {
  return contests > 0 ? std::optional(static_cast<double>(contests - finished) / contests) : std::nullopt;
}

std::vector<MazeScores> maze_scores(const Race& race, std::size_t mouse) {
  const double limit = race.world().traits().limit_score;
  std::vector<MazeScores> scores(race.mazes.size());
  for (const ContestResult& contest : race.results)
    if (contest.mouse == mouse && counts(race, contest))
      scores[contest.maze].add(contest.score, contest.counted.value_or(limit));
  return scores;
}

}  // namespace labmouse
