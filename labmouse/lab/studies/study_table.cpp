#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "labmouse/lab/standings/race_notes.hpp"
#include "labmouse/lab/standings/race_table.hpp"
#include "labmouse/lab/studies/dropped_mazes.hpp"
#include "labmouse/lab/studies/ratios.hpp"
#include "labmouse/lab/studies/study.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/counted.hpp"

namespace labmouse {
namespace {

std::string line(bool bold, const std::string& text) {
  return fmt::format("{}{}{}\n", bold ? "\x1b[1m" : "", text, bold ? "\x1b[0m" : "");
}

std::string name_of(const Study& study, const Comparison& comparison) {
  return study.race.mice[comparison.mouse].name + " - " + study.race.mice[comparison.against].name;
}

std::string probability(double p) { return p < 0.001 ? "<0.001" : fmt::format("{:.3f}", p); }

/// A line of differences, multiplied by `factor`. The line of the finished contests alone has no verdict.
struct Line {
  std::string name;
  const PairedDifference& found;
  double factor = 1.0;
  std::optional<double> p;
  std::string_view verdict;
};

std::string text_of(const Line& line, std::size_t width) {
  const PairedDifference& found = line.found;
  const Interval ends = scaled(found.interval, line.factor);
  const std::string interval =
      found.count > 1 ? fmt::format("{:+.3f} to {:+.3f}", ends.low + 0.0, ends.high + 0.0) : "-";
  return fmt::format("{:<{}} {:>8} {:>18} {:>6} {:>5} {:>5} {:>6} {:>6}{}\n", line.name, width,
                     found.count > 0 ? fmt::format("{:+.3f}", line.factor * found.mean + 0.0) : "-", interval,
                     line.p ? probability(*line.p) : "-", found.below, found.equal, found.above,
                     probability(found.sign_test), line.verdict.empty() ? "" : fmt::format("  {}", line.verdict));
}

/// The lines of one comparison: the scores, and where failed contests have no score, the shares of finished contests.
std::vector<Line> lines_of(const Study& study, const Comparison& comparison) {
  const MousePair& pair = comparison.pair;
  const PairVerdicts& verdicts = comparison.verdicts;
  std::vector<Line> lines = {
      {name_of(study, comparison), pair.scores, 1.0, verdicts.scores_p, name_of(verdicts.scores)}};
  if (!pair.has_rates) return lines;
  lines.push_back({"  finished, %", pair.rates.failed, -100.0, verdicts.rates_p, name_of(verdicts.rates)});
  lines.push_back({"  finished only", pair.rates.finished_only, 1.0, std::nullopt, ""});
  return lines;
}

std::string comparisons_text(const Study& study, const std::vector<Comparison>& comparisons, bool colours) {
  std::size_t width = 10;
  std::vector<Line> lines;
  for (const Comparison& comparison : comparisons)
    for (Line& line : lines_of(study, comparison)) lines.push_back(std::move(line));
  for (const Line& each : lines) width = std::max(width, each.name.size());
  std::string text =
      line(colours, fmt::format("{:<{}} {:>8} {:>18} {:>6} {:>5} {:>5} {:>6} {:>6}  {}", "difference", width, "mean",
                                "95 % interval", "p", "wins", "ties", "losses", "sign p", "verdict"));
  for (const Line& each : lines) text += text_of(each, width);
  return text;
}

std::string ratio_text(const std::vector<FigureRatio>& ratios, std::string_view figure) {
  const auto found =
      std::find_if(ratios.begin(), ratios.end(), [&](const FigureRatio& r) { return r.figure == figure; });
  if (found == ratios.end()) return "-";
  const Interval& interval = found->found.interval;
  const std::string ratio = fmt::format("{:.3f}", found->found.ratio);
  return found->mazes > 1 ? fmt::format("{} [{:.3f}, {:.3f}]", ratio, interval.low, interval.high) : ratio;
}

/// A line for each comparison and a column for each figure in any of them; empty without figures.
std::string ratios_text(const Study& study, const std::vector<Comparison>& comparisons, bool colours) {
  std::vector<std::string> names;
  std::vector<std::vector<FigureRatio>> all;
  std::vector<std::string_view> figures;
  std::size_t width = 10;
  for (const Comparison& comparison : comparisons) {
    names.push_back(study.race.mice[comparison.mouse].name + " / " + study.race.mice[comparison.against].name);
    width = std::max(width, names.back().size());
    all.push_back(ratios_of(study, comparison));
    for (const FigureRatio& ratio : all.back())
      if (std::find(figures.begin(), figures.end(), ratio.figure) == figures.end()) figures.push_back(ratio.figure);
  }
  if (figures.empty()) return "";
  std::string heading = fmt::format("{:<{}}", "ratio of", width);
  for (const std::string_view figure : figures) heading += fmt::format(" {:>22}", figure);
  std::string text = line(colours, heading);
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += fmt::format("{:<{}}", names[i], width);
    for (const std::string_view figure : figures) text += fmt::format(" {:>22}", ratio_text(all[i], figure));
    text += "\n";
  }
  return text + "\n";
}

/// A note about which mice have learned, and from how many mazes.
std::string learning_note(const Study& study) {
  if (study.learners.empty()) return "None of these mice learns; each races as it is.\n";
  const std::string names = fmt::format("{}", fmt::join(study.learners, ", "));
  if (!study.order.learning)
    return fmt::format("Not taught here: {}; what it knows may come from these very mazes.\n", names);
  const auto [least, most] = std::minmax_element(study.fold_sizes.begin(), study.fold_sizes.end());
  const std::size_t all = study.selection.mazes.size();
  const std::string sizes =
      *least == *most ? fmt::format("{}", all - *most) : fmt::format("{} or {}", all - *most, all - *least);
  return fmt::format("Taught anew for each fold, from the {} mazes of the other folds: {}.\n", sizes, names);
}

std::string notes_of(const Study& study, const std::vector<Comparison>& comparisons) {
  std::string notes = score_note(*study.order.race.world);
  if (!comparisons.empty())
    notes +=
        "Differences are maze by maze: below 0, and a win, means that the mouse before the minus is better.\n"
        "Ratios are of the means over the mazes in which both mice have the figure, with 95 % intervals.\n";
  if (!comparisons.empty() && comparisons.front().pair.has_rates)
    notes += fmt::format(
        "Differences count a failed contest as {:g} {}; 'finished only' leaves failed contests out, and so has no "
        "verdict.\n",
        study.order.race.world->traits().limit_score, study.order.race.world->traits().unit);
  notes += verdict_notes(judged(pairs_of(comparisons)));
  if (study.mice.size() > most_in_all_pairs) notes += "Mice are compared only with the first one named.\n";
  notes += learning_note(study) + left_out_notes(study.selection, ", all of them in --format json");
  if (std::any_of(study.race.mice.begin(), study.race.mice.end(), [](const Contestant& m) { return m.reference; }))
    notes += "* knows the maze: attains the bound, and is not a contestant.\n";
  if (study.race.stopped)
    notes += fmt::format("Stopped early: {} of {} folds done, {} of {} mazes.\n", study.folds_done, study.order.folds,
                         study.race.mazes.size(), study.selection.mazes.size());
  return notes;
}

}  // namespace

std::string table_of(const Study& study, bool colours) {
  const World& world = *study.order.race.world;
  std::string text =
      fmt::format("labmouse {}: {}{}, {} in {} folds, seed {}{}\n\n", version(), world.title(),
                  counted(study.mice.size(), "mouse", "mice"), counted(study.selection.mazes.size(), "maze", "mazes"),
                  study.order.folds, study.order.race.seed, world.traits().heading);
  text += leaderboard_of(study.race, colours) + "\n";
  const std::vector<Comparison> comparisons = comparisons_of(study);
  if (!comparisons.empty())
    text += comparisons_text(study, comparisons, colours) + "\n" + ratios_text(study, comparisons, colours);
  return text + notes_of(study, comparisons);
}

}  // namespace labmouse
