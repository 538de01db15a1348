#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/drawing/plot.hpp"
#include "labmouse/lab/standings/race_notes.hpp"
#include "labmouse/lab/studies/tune.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/counted.hpp"

namespace labmouse {
namespace {

/// A value of the objective or a difference of two: a score with three decimals, a ratio with four.
std::string shown_value(const Tune& tune, double value, bool sign = false) {
  const int decimals = tune.order.objective == Objective::ratio ? 4 : 3;
  return sign ? fmt::format("{:+.{}f}", value, decimals) : fmt::format("{:.{}f}", value, decimals);
}

std::string parameters_text(const Tune& tune, bool colours) {
  std::size_t width = 9;
  for (const ParameterRange& range : tune.ranges) width = std::max(width, range.parameter.name.size());
  std::string text = fmt::format("{}{:<{}} {:>9} {:>9} {:>11} {:>11}{}\n", colours ? "\x1b[1m" : "", "parameter", width,
                                 "low", "high", "given", "best", colours ? "\x1b[0m" : "");
  const Evaluation &given = tune.evaluations.front(), &best = best_of(tune);
  for (std::size_t i = 0; i < tune.ranges.size(); ++i) {
    const ParameterRange& range = tune.ranges[i];
    text +=
        fmt::format("{:<{}} {:>9} {:>9} {:>11} {:>11}\n", range.parameter.name, width, written_value(range, range.low),
                    written_value(range, range.high), given.values[i], best.values[i]);
  }
  return text;
}

std::string gain_text(const Tune& tune) {
  const Gain gain = gain_of(tune);
  std::string text = "difference " + shown_value(tune, gain.mean, true);
  if (gain.interval)
    text += fmt::format(" [{}, {}]", shown_value(tune, gain.interval->low, true),
                        shown_value(tune, gain.interval->high, true));
  return text + fmt::format(" over {} ({} better, {} equal, {} worse)\n", counted(tune.mazes, "maze", "mazes"),
                            gain.better, gain.equal, gain.worse);
}

std::string failures_text(int failures) {
  return failures == 0 ? "" : fmt::format(", {} failed", counted(failures, "contest", "contests"));
}

std::string result_text(const Tune& tune) {
  const Evaluation &given = tune.evaluations.front(), &best = best_of(tune);
  std::string text = fmt::format("as given   {}{}\n", shown_value(tune, given.value), failures_text(given.failures));
  if (&best == &given)
    return text +
           fmt::format("No better values in {}.\n", counted(tune.evaluations.size(), "evaluation", "evaluations"));
  return text +
         fmt::format("best       {}, evaluation {} of {}{}\n", shown_value(tune, best.value), &best - &given + 1,
                     tune.evaluations.size(), failures_text(best.failures)) +
         gain_text(tune);
}

std::string notes_of(const Tune& tune) {
  std::string notes = limit_note(*tune.order.race.world);
  if (tune.order.objective == Objective::ratio) notes += "Tuned for the mean of score / bound over the mazes.\n";
  if (tune.routeless > 0)
    notes += fmt::format("Left out of all means: {} whose goal cannot be reached.\n",
                         counted(tune.routeless, "maze", "mazes"));
  if (tune.stopped)
    notes +=
        fmt::format("Stopped early: {} of {} evaluations done.\n", tune.evaluations.size(), tune.order.evaluations);
  if (!tune.evaluations.empty() && &best_of(tune) != &tune.evaluations.front())
    notes +=
        "In-sample: the best was chosen on these very mazes, so the difference and interval\n"
        "are optimistic. Confirm it on mazes it has not seen, with `labmouse study`.\n";
  return notes;
}

/// A generation as a point of the plot: the mean of its evaluations, and the best one as the lower end of the whisker.
PlotPoint point_of(const Tune& tune, std::size_t begin, std::size_t end) {
  double sum = 0.0, best = tune.evaluations[begin].value, best_before = best + 1.0;
  for (std::size_t i = 0; i < begin; ++i) best_before = std::min(best_before, tune.evaluations[i].value);
  for (std::size_t i = begin; i < end; ++i) {
    sum += tune.evaluations[i].value;
    best = std::min(best, tune.evaluations[i].value);
  }
  const double middle = sum / static_cast<double>(end - begin);
  const bool first = begin == 0;
  const std::string words = first ? fmt::format("as given: {}", shown_value(tune, middle))
                                  : fmt::format("generation {}: mean {}, best {}", tune.evaluations[begin].generation,
                                                shown_value(tune, middle), shown_value(tune, best));
  const auto whisker = first ? std::nullopt : std::optional(Interval{best, middle});
  return {fmt::format("{}", end), middle, whisker, !first && best < best_before, words};
}

}  // namespace

std::string table_of(const Tune& tune, bool colours) {
  const World& world = *tune.order.race.world;
  std::string text = fmt::format("labmouse {}: {}tune, {}, {}, seed {}{}\n\n", version(), world.title(),
                                 counted(tune.ranges.size(), "parameter", "parameters"),
                                 counted(static_cast<int>(tune.mazes) + tune.routeless, "maze", "mazes"),
                                 tune.order.race.seed, world.traits().heading);
  if (tune.evaluations.empty()) return text + notes_of(tune);
  return text + parameters_text(tune, colours) + "\n" + result_text(tune) + "\n" + notes_of(tune) + "\n" +
         best_of(tune).mouse + "\n";
}

std::string csv_of(const Tune& tune) {
  std::string text = fmt::format("evaluation,generation,step,{},failures",
                                 tune.order.objective == Objective::ratio ? "ratio" : "score");
  for (const ParameterRange& range : tune.ranges) text += fmt::format(",{}", range.parameter.name);
  text += ",mouse\n";
  for (std::size_t i = 0; i < tune.evaluations.size(); ++i) {
    const Evaluation& evaluation = tune.evaluations[i];
    text += fmt::format("{},{},{:.4g},{},{},{},{}\n", i + 1, evaluation.generation, evaluation.step, evaluation.value,
                        evaluation.failures, fmt::join(evaluation.values, ","), evaluation.mouse);
  }
  return text;
}

std::string picture_of(const Tune& tune) {
  Plot plot;
  const bool ratio = tune.order.objective == Objective::ratio;
  if (!tune.evaluations.empty()) {
    plot.title = fmt::format("Tuning of {} in {}{}", tune.evaluations.front().mouse,
                             counted(tune.mazes, "maze", "mazes"), tune.stopped ? ", stopped early" : "");
    plot.description = fmt::format("{} after {}: {}.", ratio ? "Best ratio" : "Best score",
                                   counted(tune.evaluations.size(), "evaluation", "evaluations"),
                                   shown_value(tune, best_of(tune).value));
  }
  plot.x_label = "evaluations";
  plot.y_label = ratio ? "score / bound (lower is better)"
                       : fmt::format("mean score ({}; lower is better)", tune.order.race.world->traits().unit);
  for (std::size_t begin = 0, end = 0; begin < tune.evaluations.size(); begin = end) {
    while (end < tune.evaluations.size() && tune.evaluations[end].generation == tune.evaluations[begin].generation)
      ++end;
    plot.points.push_back(point_of(tune, begin, end));
  }
  plot.mean_words = "mean of a generation";
  plot.hollow_words = "mean of a generation whose best is the lowest so far";
  plot.interval_words = "down to the best of the generation";
  return draw_plot(plot);
}

}  // namespace labmouse
