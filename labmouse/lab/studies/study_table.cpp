#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/studies/dropped_mazes.hpp"
#include "labmouse/lab/studies/study.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/counted.hpp"

namespace labmouse {
namespace {

std::string number(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

std::string line(bool bold, const std::string& text) {
  return fmt::format("{}{}{}\n", bold ? "\x1b[1m" : "", text, bold ? "\x1b[0m" : "");
}

/// The cells of one line of the standings, mouse first.
using Line = std::array<std::string, 8>;

std::string laid_out(const Line& cells, std::size_t width) {
  return fmt::format("{:<{}} {:>8} {:>13} {:>7} {:>6} {:>6} {:>6} {:>7}", cells[0], width, cells[1], cells[2], cells[3],
                     cells[4], cells[5], cells[6], cells[7]);
}

std::string marked_name(const Contestant& mouse) { return mouse.name + (mouse.reference ? " *" : ""); }

Line line_of(const Study& study, const Standing& standing) {
  const bool spread = standing.mazes > 1;
  return {marked_name(study.race.mice[standing.mouse]),
          number(standing.penalised_mean, 3),
          spread ? fmt::format("{:.2f}-{:.2f}", standing.interval.low, standing.interval.high) : "-",
          number(standing.mean_ratio, 3),
          number(standing.mean_exploration, 1),
          number(standing.mean_speed_over_optimum, 2),
          standing.runs > 0 ? fmt::format("{:.1f}", 100.0 * standing.optimal_share) : "-",
          fmt::format("{}", standing.runs - standing.solved)};
}

std::string standings_text(const Study& study, bool colours) {
  std::size_t width = 5;
  for (const Contestant& mouse : study.race.mice) width = std::max(width, marked_name(mouse).size());
  std::string text = line(colours, laid_out({"", "", "95 %", "score", "expl.", "speed", "best", "failed"}, width));
  text += line(colours, laid_out({"mouse", "score", "interval", "/bound", "steps", "+steps", "runs%", "runs"}, width));
  for (const Standing& standing : standings_of(study.race)) text += laid_out(line_of(study, standing), width) + "\n";
  return text;
}

std::string name_of(const Study& study, const Comparison& comparison) {
  return study.race.mice[comparison.mouse].name + " - " + study.race.mice[comparison.against].name;
}

std::string probability(double p) { return p < 0.001 ? "<0.001" : fmt::format("{:.3f}", p); }

std::string line_of(const Study& study, const Comparison& comparison, std::size_t width) {
  const PairedDifference& found = comparison.found;
  const std::string interval =
      found.count > 1 ? fmt::format("{:+.3f} to {:+.3f}", found.interval.low, found.interval.high) : "-";
  return fmt::format("{:<{}} {:>8} {:>18} {:>5} {:>5} {:>6} {:>6}\n", name_of(study, comparison), width,
                     found.count > 0 ? fmt::format("{:+.3f}", found.mean) : "-", interval, found.below, found.equal,
                     found.above, probability(found.sign_test));
}

std::string comparisons_text(const Study& study, const std::vector<Comparison>& comparisons, bool colours) {
  std::size_t width = 10;
  for (const Comparison& comparison : comparisons) width = std::max(width, name_of(study, comparison).size());
  std::string text = line(colours, fmt::format("{:<{}} {:>8} {:>18} {:>5} {:>5} {:>6} {:>6}", "difference", width,
                                               "mean", "95 % interval", "wins", "ties", "losses", "sign p"));
  for (const Comparison& comparison : comparisons) text += line_of(study, comparison, width);
  return text;
}

/// Which mice were taught from what.
std::string learning_note(const Study& study) {
  if (study.learners.empty()) return "None of these mice learns: each is raced as it is.\n";
  const std::string names = fmt::format("{}", fmt::join(study.learners, ", "));
  if (!study.order.learning)
    return fmt::format("Not taught here: {}, with what it knows, maybe from these mazes.\n", names);
  const auto [least, most] = std::minmax_element(study.fold_sizes.begin(), study.fold_sizes.end());
  const std::size_t all = study.selection.mazes.size();
  const std::string sizes =
      *least == *most ? fmt::format("{}", all - *most) : fmt::format("{} or {}", all - *most, all - *least);
  return fmt::format("Taught anew for each fold, from the {} mazes of the others: {}.\n", sizes, names);
}

std::string notes_of(const Study& study, std::size_t comparisons) {
  const Rules& rules = study.order.race.rules;
  std::string notes = fmt::format(
      "Score: speed-run steps + exploration steps / {}; lower is better.\n"
      "A failed contest counts {:g}, and is left out of '/bound', 'steps' and '+steps'.\n",
      rules.exploration_factor, rules.failure_score);
  if (comparisons > 0) notes += "Differences maze by maze: below 0, and a win, where the first mouse is better.\n";
  if (comparisons > 1)
    notes += fmt::format("Each of the {} intervals holds by itself: of twenty, one misses by chance.\n", comparisons);
  if (study.mice.size() > most_in_all_pairs) notes += "Compared with the first mouse named only.\n";
  notes += learning_note(study) + left_out_notes(study.selection, ", all of them in --format json");
  if (std::any_of(study.race.mice.begin(), study.race.mice.end(), [](const Contestant& m) { return m.reference; }))
    notes += "* knows the maze: the bound's witness, not a contestant.\n";
  if (study.race.stopped)
    notes += fmt::format("Stopped early: {} of {} folds done, {} of {} mazes.\n", study.folds_done, study.order.folds,
                         study.race.mazes.size(), study.selection.mazes.size());
  return notes;
}

}  // namespace

std::string table_of(const Study& study, bool colours) {
  const int budget = study.order.race.rules.budget;
  std::string text = fmt::format(
      "labmouse {}: {}, {} in {} folds, seed {}{}\n\n", version(), counted(std::ssize(study.mice), "mouse", "mice"),
      counted(std::ssize(study.selection.mazes), "maze", "mazes"), study.order.folds, study.order.race.seed,
      budget == Rules().budget ? "" : fmt::format(", budget {}", budget));
  text += standings_text(study, colours) + "\n";
  const std::vector<Comparison> comparisons = comparisons_of(study);
  if (!comparisons.empty()) text += comparisons_text(study, comparisons, colours) + "\n";
  return text + notes_of(study, comparisons.size());
}

}  // namespace labmouse
