#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/drawing/plot.hpp"
#include "labmouse/lab/standings/race_notes.hpp"
#include "labmouse/lab/studies/sweep.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string interval_text(const SweepPoint& point) {
  return point.interval ? fmt::format("{:.3f}-{:.3f}", point.interval->low, point.interval->high) : "-";
}

std::string line_of(const SweepPoint& point, std::size_t width) {
  return fmt::format("{:>{}} {:>8} {:>16} {:>7} {:>9}\n", point.value, width,
                     point.mean ? fmt::format("{:.3f}", *point.mean) : "-", interval_text(point), point.failures,
                     point.runs);
}

/// How many contests the values count: one number, or two where the mouse throws dice only at some of them.
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

/// What the intervals run over.
std::string spread(const Sweep& sweep) {
  if (sweep.mazes.size() > 1) return fmt::format("over the {} mazes", sweep.mazes.size());
  return fmt::format("over the {} runs in one maze", runs_text(sweep));
}

/// The lowest mean and where it is; nothing where there is no mean.
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
  if (best == nullptr) return "";
  return fmt::format("Lowest mean: {:.3f} at {}={}{}.", *best->mean, sweep.parameter, best->value,
                     others == 0 ? "" : " and " + counted(others, "other value", "other values"));
}

std::string notes_of(const Sweep& sweep) {
  std::string notes = score_note(*sweep.order.world);
  if (has_intervals(sweep)) notes += fmt::format("95 % interval of the mean {}.\n", spread(sweep));
  if (const std::string best = lowest(sweep); !best.empty()) notes += best + "\n";
  if (sweep.routeless > 0)
    notes += fmt::format("Left out of all means: {} {}.\n",
                         counted(static_cast<std::size_t>(sweep.routeless), "maze", "mazes"),
                         sweep.order.world->why_no_bound());
  if (sweep.points.size() < sweep.values)
    notes += fmt::format("Stopped early: {} of {} values done.\n", sweep.points.size(), sweep.values);
  return notes;
}

/// The mazes in few words: the one's name, or their number.
std::string place_of(const Sweep& sweep) {
  if (sweep.mazes.size() != 1) return fmt::format("{} mazes", sweep.mazes.size());
  const std::string& name = sweep.mazes.front();
  return name.substr(name.rfind('/') + 1);
}

PlotPoint plot_point(const Sweep& sweep, const SweepPoint& point) {
  std::string words = fmt::format("{}={}: mean {:.3f}", sweep.parameter, point.value, *point.mean);
  if (point.interval)
    words += fmt::format(", 95 % interval {:.3f} to {:.3f}", point.interval->low, point.interval->high);
  words += fmt::format(", {} of {} failed", point.failures,
                       counted(static_cast<std::size_t>(point.runs), "contest", "contests"));
  return {point.value, *point.mean, point.interval, point.failures > 0, words};
}

}  // namespace

std::string table_of(const Sweep& sweep, bool colours) {
  std::size_t width = std::max<std::size_t>(5, sweep.parameter.size());
  for (const SweepPoint& point : sweep.points) width = std::max(width, point.value.size());
  const std::size_t mazes = sweep.mazes.size() + static_cast<std::size_t>(sweep.routeless);
  std::string text =
      fmt::format("labmouse {}: {}, {}, {}, seed {}\n\n", version(), sweep.mouse,
                  counted(sweep.values, "value", "values"), counted(mazes, "maze", "mazes"), sweep.order.seed);
  text += fmt::format("{}{:>{}} {:>8} {:>16} {:>7} {:>9}{}\n", colours ? "\x1b[1m" : "", sweep.parameter, width, "mean",
                      "95 % interval", "failed", "contests", colours ? "\x1b[0m" : "");
  for (const SweepPoint& point : sweep.points) text += line_of(point, width);
  return text + "\n" + notes_of(sweep);
}

std::string csv_of(const Sweep& sweep) {
  std::string text = "value,mean,low,high,failures,runs\n";
  const auto field = [](bool there, double value) { return there ? fmt::format("{}", value) : std::string(); };
  for (const SweepPoint& point : sweep.points) {
    const Interval interval = point.interval.value_or(Interval());
    text += fmt::format("{},{},{},{},{},{}\n", point.value, field(point.mean.has_value(), point.mean.value_or(0.0)),
                        field(point.interval.has_value(), interval.low),
                        field(point.interval.has_value(), interval.high), point.failures, point.runs);
  }
  return text;
}

std::string picture_of(const Sweep& sweep) {
  Plot plot;
  plot.title = fmt::format("{} in {}: score by {}{}", sweep.mouse, place_of(sweep), sweep.parameter,
                           sweep.points.size() < sweep.values ? ", stopped early" : "");
  plot.description = fmt::format("Mean score of {} at {} of {}. {}", sweep.mouse,
                                 counted(sweep.points.size(), "value", "values"), sweep.parameter, lowest(sweep));
  plot.x_label = sweep.parameter + (sweep.meaning.empty() ? "" : ": " + sweep.meaning);
  plot.y_label = fmt::format("mean score ({}; lower is better)", sweep.order.world->unit());
  for (const SweepPoint& point : sweep.points)
    if (point.mean) plot.points.push_back(plot_point(sweep, point));
  const std::string runs = runs_text(sweep), contests = runs + (runs == "1" ? " contest" : " contests");
  plot.mean_words = "mean of " + contests;
  const auto failed = sweep.order.world->failure_score();
  plot.hollow_words = failed ? fmt::format("mean of {}, failures counted {:g}", contests, *failed)
                             : fmt::format("mean of {}, failures left out", contests);
  plot.interval_words = "95 % interval " + spread(sweep);
  return draw_plot(plot);
}

}  // namespace labmouse
