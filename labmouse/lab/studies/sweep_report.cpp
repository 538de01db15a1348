#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "labmouse/lab/drawing/plot.hpp"
#include "labmouse/lab/standings/pair_report.hpp"
#include "labmouse/lab/standings/race_notes.hpp"
#include "labmouse/lab/studies/sweep.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// The mouse, with the robot if its numbers are swept.
std::string name_of(const Sweep& sweep) {
  return sweep.robot.empty() ? sweep.mouse : fmt::format("{} with {}", sweep.mouse, sweep.robot);
}

std::string interval_text(const SweepPoint& point) {
  if (!point.interval) return "-";
  const std::string_view between = point.interval->low < 0.0 ? " to " : "-";
  return fmt::format("{:.3f}{}{:.3f}", point.interval->low, between, point.interval->high);
}

std::string mean_text(const std::optional<double>& mean) { return mean ? fmt::format("{:.3f}", *mean) : "-"; }

/// Whether failed contests have no score; if so, the mean of the finished ones has its own column.
bool has_finished_means(const Sweep& sweep) { return !sweep.order.world->traits().failure_score; }

std::string line_of(const Sweep& sweep, const SweepPoint& point, std::size_t width) {
  const std::string finished = has_finished_means(sweep) ? fmt::format(" {:>13}", mean_text(point.finished_mean)) : "";
  return fmt::format("{:>{}} {:>8} {:>16} {:>7} {:>9}{}", point.value, width, mean_text(point.mean),
                     interval_text(point), point.failures, point.runs, finished);
}

/// The differences of all points that have one, in their order.
std::vector<MousePair> pairs_of(const Sweep& sweep) {
  std::vector<MousePair> pairs;
  for (const SweepPoint& point : sweep.points)
    if (point.against_first) pairs.push_back(*point.against_first);
  return pairs;
}

/// A line for each point, with its difference where it has one.
std::string lines_of(const Sweep& sweep, std::size_t width) {
  const std::vector<PairVerdicts> verdicts = verdicts_of(pairs_of(sweep));
  std::string text;
  std::size_t next = 0;
  for (const SweepPoint& point : sweep.points) {
    text += line_of(sweep, point, width);
    if (point.against_first) text += difference_columns(point.against_first->scores, verdicts[next++].scores);
    text += "\n";
  }
  return text;
}

/// The number of contests at each value, as text: one number, or a range where the mouse is stochastic only at some
/// values.
std::string runs_text(const Sweep& sweep) {
  int fewest = 0, most = 0;
  for (const SweepPoint& point : sweep.points) {
    fewest = most == 0 ? point.runs : std::min(fewest, point.runs);
    most = std::max(most, point.runs);
  }
  return fewest == most ? fmt::format("{}", most) : fmt::format("{} to {}", fewest, most);
}

bool has_intervals(const Sweep& sweep) {
  return std::any_of(sweep.points.begin(), sweep.points.end(),
                     [](const SweepPoint& point) { return point.interval.has_value(); });
}

/// The unit of the intervals: mazes or runs.
std::string spread(const Sweep& sweep) {
  if (sweep.mazes.size() > 1) return fmt::format("over the {} mazes", sweep.mazes.size());
  return fmt::format("over the {} runs in one maze", runs_text(sweep));
}

/// The lowest mean and its value, in words; empty if all its contests failed.
std::string lowest(const Sweep& sweep) {
  const SweepPoint* best = nullptr;
  std::size_t others = 0;
  for (const SweepPoint& point : sweep.points) {
    if (!point.mean) continue;
    if (best != nullptr && *point.mean == *best->mean) ++others;
    if (best != nullptr && *point.mean >= *best->mean) continue;
    best = &point;
    others = 0;
  }
  if (best == nullptr || best->failures == best->runs) return "";
  return fmt::format("Lowest mean: {:.3f} at {}={}{}.", *best->mean, sweep.parameter, best->value,
                     others == 0 ? "" : " and " + counted(others, "other value", "other values"));
}

std::string notes_of(const Sweep& sweep) {
  std::string notes = limit_note(*sweep.order.world);
  if (has_finished_means(sweep)) notes += "'finished only' leaves failed contests out.\n";
  if (has_intervals(sweep)) notes += fmt::format("95 % interval of the mean {}.\n", spread(sweep));
  if (const std::string best = lowest(sweep); !best.empty()) notes += best + "\n";
  const std::vector<MousePair> pairs = pairs_of(sweep);
  if (!pairs.empty())
    notes += fmt::format("The difference is to the first value, maze by maze; below 0, the robot is better.\n{}",
                         verdict_notes(judged(pairs)));
  if (sweep.points.size() > 1)
    notes += fmt::format(
        "The intervals are not corrected for the {} values: the lowest of so many means is partly chance. Compare it "
        "with `labmouse study` on other mazes.\n",
        sweep.points.size());
  if (sweep.routeless > 0)
    notes += fmt::format("Left out of all means: {} {}.\n", counted(sweep.routeless, "maze", "mazes"),
                         sweep.order.world->traits().why_no_bound);
  if (sweep.points.size() < sweep.values)
    notes += fmt::format("Stopped early: {} of {} values done.\n", sweep.points.size(), sweep.values);
  return notes;
}

/// The mazes in words: the name of a single one, else their number.
std::string place_of(const Sweep& sweep) {
  if (sweep.mazes.size() != 1) return fmt::format("{} mazes", sweep.mazes.size());
  const std::string& name = sweep.mazes.front();
  return name.substr(name.rfind('/') + 1);
}

PlotPoint plot_point(const Sweep& sweep, const SweepPoint& point) {
  std::string words = fmt::format("{}={}: mean {:.3f}", sweep.parameter, point.value, *point.mean);
  if (point.interval)
    words += fmt::format(", 95 % interval {:.3f} to {:.3f}", point.interval->low, point.interval->high);
  words += fmt::format(", {} of {} failed", point.failures, counted(point.runs, "contest", "contests"));
  return {point.value, *point.mean, point.interval, point.failures > 0, words};
}

}  // namespace

std::string table_of(const Sweep& sweep, bool colours) {
  std::size_t width = std::max<std::size_t>(5, sweep.parameter.size());
  for (const SweepPoint& point : sweep.points) width = std::max(width, point.value.size());
  const std::size_t mazes = sweep.mazes.size() + static_cast<std::size_t>(sweep.routeless);
  const World& world = *sweep.order.world;
  std::string text = fmt::format("labmouse {}: {}{}, {}, {}, seed {}{}\n\n", version(), world.title(), name_of(sweep),
                                 counted(sweep.values, "value", "values"), counted(mazes, "maze", "mazes"),
                                 sweep.order.seed, world.traits().heading);
  text += fmt::format("{}{:>{}} {:>8} {:>16} {:>7} {:>9}{}{}{}\n", colours ? "\x1b[1m" : "", sweep.parameter, width,
                      "mean", "95 % interval", "failed", "contests",
                      has_finished_means(sweep) ? fmt::format(" {:>13}", "finished only") : "",
                      sweep.robot.empty() ? "" : difference_heading(), colours ? "\x1b[0m" : "");
  return text + lines_of(sweep, width) + "\n" + notes_of(sweep);
}

std::string picture_of(const Sweep& sweep) {
  Plot plot;
  plot.title = fmt::format("{} in {}: score by {}{}", name_of(sweep), place_of(sweep), sweep.parameter,
                           sweep.points.size() < sweep.values ? ", stopped early" : "");
  plot.description = fmt::format("Mean score of {} at {} of {}. {}", name_of(sweep),
                                 counted(sweep.points.size(), "value", "values"), sweep.parameter, lowest(sweep));
  plot.x_label = sweep.parameter + (sweep.meaning.empty() ? "" : ": " + sweep.meaning);
  plot.y_label = fmt::format("mean score ({}; lower is better)", sweep.order.world->traits().unit);
  for (const SweepPoint& point : sweep.points)
    if (point.mean) plot.points.push_back(plot_point(sweep, point));
  const std::string runs = runs_text(sweep), contests = runs + (runs == "1" ? " contest" : " contests");
  plot.mean_words = "mean of " + contests;
  plot.hollow_words =
      fmt::format("mean of {}, failures counted {:g}", contests, sweep.order.world->traits().limit_score);
  plot.interval_words = "95 % interval " + spread(sweep);
  return draw_plot(plot);
}

}  // namespace labmouse
