#include "labmouse/lab/records/explanation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "labmouse/lab/text/counted.hpp"

namespace labmouse {
namespace {

double in_steps(double cost) { return cost / costs_a_step; }

/// A cost as a number of steps, with decimals only where it has some.
std::string steps_text(double cost) {
  const double steps = in_steps(cost);
  return steps == static_cast<double>(static_cast<int>(steps)) ? fmt::format("{:.0f}", steps)
                                                               : fmt::format("{:.2f}", steps);
}

std::string text_of(Cell cell) { return fmt::format("({},{})", cell.x, cell.y); }

std::string label_of(const Candidate& candidate) {
  if (candidate.goal) return "goal " + text_of(candidate.seen_from);
  return fmt::format("{} {}", text_of(candidate.wall.cell), name_of(candidate.wall.side));
}

const Candidate* chosen_of(const Reasons& reasons) {
  return reasons.chosen < 0 ? nullptr : &reasons.candidates[static_cast<std::size_t>(reasons.chosen)];
}

/// The candidate whose run costs `hope`: the one that came closest to being chosen. Of several, the one with the
/// shortest way to it.
const Candidate* nearest_to_worth(const Reasons& reasons) {
  const Candidate* nearest = nullptr;
  for (const Candidate& candidate : reasons.candidates)
    if (candidate.through == reasons.hope && (nearest == nullptr || candidate.travel < nearest->travel))
      nearest = &candidate;
  return nearest;
}

/// The candidates in the order of the table: first the chosen one (or nearest_to_worth(), where none is chosen), then
/// those worth the trip, then the others; both groups by score, the lowest first.
std::vector<const Candidate*> ranked(const Reasons& reasons) {
  std::vector<const Candidate*> candidates;
  for (const Candidate& candidate : reasons.candidates) candidates.push_back(&candidate);
  const Candidate* first = reasons.chosen < 0 ? nearest_to_worth(reasons) : chosen_of(reasons);
  const auto rank = [&](const Candidate* candidate) {
    return std::make_tuple(candidate != first, !candidate->worth, candidate->score);
  };
  std::stable_sort(candidates.begin(), candidates.end(), [&](auto* a, auto* b) { return rank(a) < rank(b); });
  return candidates;
}

std::string row_of(const Candidate& candidate, const Reasons& reasons) {
  const char mark = &candidate == chosen_of(reasons) ? '>' : candidate.worth ? ' ' : '-';
  const double through = candidate.goal ? reasons.way_here * candidate.through : candidate.through;
  return fmt::format("  {} {:<16}{:<10}{:>8.2f}{:>8}{:>9.2f}\n", mark, label_of(candidate),
                     text_of(candidate.seen_from), in_steps(through), candidate.travel, in_steps(candidate.score));
}

std::string table_of(const Reasons& reasons, int rows) {
  if (reasons.candidates.empty()) return "";
  const bool ahead = reasons.way_here < 1;
  std::string table =
      fmt::format("    {:<16}{:<10}{:>8}{:>8}{:>9}\n", "wall", "seen from", ahead ? "T ahead" : "T", "travel", "score");
  const auto candidates = ranked(reasons);
  const std::size_t shown = std::min(candidates.size(), static_cast<std::size_t>(rows));
  for (std::size_t i = 0; i < shown; ++i) table += row_of(*candidates[i], reasons);
  if (shown < candidates.size()) table += fmt::format("    and {} more\n", candidates.size() - shown);
  return table;
}

/// The number of the first step that ends in a goal; one more than the number of steps where none does.
int step_to_goal(const RecordFile& file) {
  const auto& steps = file.run.steps;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Pose next = i + 1 < steps.size() ? steps[i + 1].pose : file.run.end;
    if (steps[i].action.kind == Action::Kind::step && file.maze->is_goal(next.cell)) return steps[i].step;
  }
  return static_cast<int>(steps.size()) + 1;
}

std::string heading_of(const StepRecord& step, std::size_t candidates, bool goal_entered) {
  return fmt::format("step {} at {} heading {}, {} the goal: {} candidate{}\n", step.step, text_of(step.pose.cell),
                     name_of(step.pose.heading), goal_entered ? "after" : "before", candidates,
                     candidates == 1 ? "" : "s");
}

/// Reports that the mouse floods from this step on: it compares no candidates, but takes the shortest way that could be
/// open. The following steps of a flood are not reported.
std::string flood_of(const StepRecord& step) {
  return fmt::format(
      "\nstep {} at ({},{}): floods from here on. The maze is large, its budget is small for it, or half of\n"
      "that was used without reaching the goal, so it takes the shortest way that could be open.\n",
      step.step, int{step.pose.cell.x}, int{step.pose.cell.y});
}

/// Why nothing was chosen after the goal was reached.
std::string hope_of(const Reasons& reasons) {
  const std::string known = fmt::format("The known run takes {} steps.\n", steps_text(reasons.known));
  const Candidate* nearest = nearest_to_worth(reasons);
  if (nearest == nullptr) return known + "No unseen wall is left that a better run could pass.\n";
  return known + fmt::format("The best hope: {} through {}; looking at it costs {}. Not worth it.\n",
                             steps_text(reasons.hope), label_of(*nearest), steps_text(reasons.price));
}

std::string reset_of(const RecordFile& file, const StepRecord& step) {
  const std::string left = fmt::format("with {} of {} steps left", file.rules.budget - step.step, file.rules.budget);
  const auto& all = file.run.reasons;
  const auto why =
      std::find_if(all.begin(), all.end(), [&](const StepReasons& each) { return each.step == step.step; });
  if (why == all.end()) return fmt::format("step {}: reset without reconsidering the walls, {}.\n", step.step, left);
  if (why->reasons.ground == Ground::no_loops)
    return fmt::format(
        "step {}: reset at the goal. The walls seen look like those of a maze without loops,\n"
        "where there is no other run. The known run takes {} steps.\n",
        step.step, steps_text(why->reasons.known));
  if (why->reasons.chosen < 0) return fmt::format("step {}: reset. ", step.step) + hope_of(why->reasons);
  return fmt::format("step {}: reset anyway, {}; the known run takes {}.\n", step.step, left,
                     steps_text(why->reasons.known));
}

/// Why the search run ended; empty where the mouse did not end it itself.
std::string ending_of(const RecordFile& file) {
  const auto& steps = file.run.steps;
  const auto race =
      std::find_if(steps.begin(), steps.end(), [](const StepRecord& step) { return step.run == Run::speed; });
  if (race == steps.begin()) return "";
  const StepRecord& last = *(race - 1);
  if (last.action.kind == Action::Kind::reset) return reset_of(file, last);
  if (last.action.kind == Action::Kind::forfeit)
    return fmt::format("step {}: forfeit, {}.\n", last.step, name_of(last.action.reason));
  return "";
}

/// Explains the columns.
std::string key_of(const RunRecord& run) {
  std::string key =
      "T: steps of the best run through that wall, guessing at walls not yet seen.\n"
      "travel: steps to the cell from which it can be seen. score: in steps; the lowest\n"
      "is chosen (>) among those worth the trip (the others are marked -).\n";
  const auto least = [](const StepReasons& a, const StepReasons& b) { return a.reasons.way_here < b.reasons.way_here; };
  const double way_here = std::min_element(run.reasons.begin(), run.reasons.end(), least)->reasons.way_here;
  if (way_here >= 1) return key;
  return key +
         fmt::format("T ahead: T with{} the way from the start to the wall.\n", way_here > 0 ? " less of" : "out");
}

}  // namespace

std::string explanation_of(const RecordFile& file, int candidates) {
  if (file.run.reasons.empty()) return "";
  const int to_goal = step_to_goal(file);
  std::string text = key_of(file.run);
  int flood_until = -1;  // the last step of a reported flood
  for (const auto& [number, reasons] : file.run.reasons) {
    const StepRecord& step = file.run.steps[static_cast<std::size_t>(number) - 1];
    const bool goes_on = flood_until == number - 1;
    if (reasons.ground == Ground::flood) flood_until = number;
    if (reasons.ground == Ground::flood && !goes_on) text += flood_of(step);
    if (reasons.ground != Ground::candidates) continue;
    text += "\n" + heading_of(step, reasons.candidates.size(), number > to_goal) + table_of(reasons, candidates);
  }
  const std::string ending = ending_of(file);
  return ending.empty() ? text : text + "\n" + ending;
}

std::string ground_words(const Reasons& reasons) {
  if (reasons.ground == Ground::flood) return "a flood, for lack of time to weigh candidates or in a large maze";
  if (reasons.ground == Ground::no_loops) return "the walls seen look like those of a maze without loops";
  if (reasons.candidates.empty()) return "no unseen wall is left that a better run could pass";
  const std::string all = counted(reasons.candidates.size(), "candidate", "candidates");
  return (reasons.chosen < 0 ? "none is worth its price, of " : "the lowest score, of ") + all;
}

}  // namespace labmouse
