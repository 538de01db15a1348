#include "labmouse/lab/drawing/words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/text/counted.hpp"

namespace labmouse::drawing {
namespace {

std::string steps(const std::vector<Pose>& poses) {
  return counted(std::max(static_cast<int>(poses.size()) - 1, 0), "step", "steps");
}

std::string share_words(const CellSet& part, const CellSet& whole, std::string_view what) {
  const double percent = whole.empty() ? 0.0 : 100.0 * part.count() / whole.count();
  return fmt::format("{} of {} {} ({:.1f} %)", part.count(), counted(whole.count(), "cell", "cells"), what, percent);
}

}  // namespace

std::string route_words(const std::vector<Leg>& legs) {
  return counted(legs.size(), "step", "steps") + ", " + counted(length_of(legs), "cell", "cells");
}

std::string to_goal_words(const SearchLegs& search_run) {
  return steps(search_run.to_goal) + (search_run.onwards.empty() ? ", no goal entered" : " to the goal");
}

std::string onwards_words(const SearchLegs& search_run) { return steps(search_run.onwards) + " from there on"; }

std::string visited_words(const ExploredCells& explored) {
  return share_words(explored.visited, explored.reachable, "visited");
}

std::string discovered_words(const ExploredCells& explored) {
  return share_words(explored.discovered, explored.reachable, "discovered");
}

std::string wrong_words(const DrawingLayers& layers) {
  const int count = layers.wrong->count();
  return layers.false_walls ? counted(count, "missed wall", "missed walls") + ": open in the map, closed in the maze"
                            : counted(count, "wrong guess", "wrong guesses") + ": closed, never seen";
}

std::string false_words(const WallSet& walls) {
  return counted(walls.count(), "false wall", "false walls") + ": closed in the map, open in the maze";
}

std::string through_words(const Candidate& candidate, const Reasons& reasons) {
  const double cost = candidate.goal ? reasons.way_here * candidate.through : candidate.through;
  return fmt::format("{:.1f}", cost / costs_a_step);
}

std::string candidates_words(const StepReasons& choice) {
  return counted(choice.reasons.candidates.size(), "candidate", "candidates") +
         fmt::format(" of step {}, with {} in steps", choice.step, choice.reasons.way_here < 1 ? "ways ahead" : "runs");
}

std::string chosen_words(const Reasons& reasons) {
  if (reasons.chosen < 0) return "none chosen";
  const Candidate& chosen = reasons.candidates[static_cast<std::size_t>(reasons.chosen)];
  return "chosen: " + through_words(chosen, reasons);
}

}  // namespace labmouse::drawing
