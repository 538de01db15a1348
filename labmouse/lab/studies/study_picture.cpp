// Pictures of studies: for each comparison its differences on the left, and both mice's scores on the right.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include "labmouse/lab/drawing/legend.hpp"
#include "labmouse/lab/drawing/plot_area.hpp"
#include "labmouse/lab/drawing/sheet.hpp"
#include "labmouse/lab/standings/maze_scores.hpp"
#include "labmouse/lab/studies/study.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

using namespace drawing;

// Pixels: two plots side by side, with room for labels on the left of each and below, and for a heading above.
constexpr int first_row = 54, heading = 34, width = 400, height = 260, label_room = 76, below = 60, margin = 24;
constexpr int one_plot = label_room + width, two_plots = 2 * one_plot;

/// One mouse's scores in each maze of the race.
struct Scores {
  std::string name;
  std::vector<std::optional<double>> values;  ///< a failed contest counts as the limit; nothing without a contest
};

Scores scores_of(const Study& study, std::size_t mouse) {
  Scores scores = {study.race.mice[mouse].name, {}};
  for (const MazeScores& maze : maze_scores(study.race, mouse)) scores.values.push_back(maze.mean());
  return scores;
}

/// An axis for all values with some margin; it does not go below 0 unless a value does.
Axis axis_of(std::vector<double> values, int begin, int end, int ticks) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double room = *high > *low ? 0.05 * (*high - *low) : 0.5;
  return {*low < 0.0 ? *low - room : std::max(0.0, *low - room), *high + room, begin, end, ticks};
}

std::string titled(std::string_view element, const std::string& attributes, const std::string& words) {
  return fmt::format("<{0} {1}><title>{2}</title></{0}>\n", element, attributes, xml_escaped(words));
}

std::string words_of(const Study& study, std::size_t maze) {
  return fmt::format("{} (fold {}, bound {:.3f})", study.race.mazes[maze].name, study.fold_of[maze] + 1,
                     *study.race.facts[maze].bound);
}

/// A bar from zero for each maze, sorted so that the best mazes of the first mouse are on the left.
std::string bars_svg(const Study& study, const Comparison& comparison, const Scores& mouse, const Scores& against,
                     const Axis& x, const Axis& y) {
  const std::vector<double>& differences = comparison.pair.differences;
  std::vector<std::size_t> order(differences.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return differences[a] < differences[b]; });
  std::string better, worse;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t maze = comparison.pair.mazes[order[i]];
    const double difference = differences[order[i]], begin = x.place(static_cast<double>(i)),
                 end = x.place(static_cast<double>(i + 1));
    const double top = y.place(std::max(difference, 0.0)), bottom = y.place(std::min(difference, 0.0));
    const std::string bar = fmt::format("x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{:.1f}\"", begin, top,
                                        end - begin, bottom - top);
    (difference < 0.0 ? better : worse) += titled("rect", bar,
                                                  fmt::format("{}: {:.3f} - {:.3f} = {:+.3f}", words_of(study, maze),
                                                              *mouse.values[maze], *against.values[maze], difference));
  }
  return fmt::format("<g {}>\n{}</g>\n<g {}>\n{}</g>\n", fill(to_goal), better, fill(route), worse);
}

std::string mean_svg(int left, int right, double at) {
  return fmt::format("<path {} stroke-width=\"2\" stroke-dasharray=\"6 4\" d=\"M{} {:.1f}H{}\"/>\n", stroke(ink), left,
                     at, right);
}

/// The interval of the mean, as a band across the plot.
std::string band_svg(int left, int right, double low, double high) {
  return fmt::format("<rect {} fill-opacity=\"0.3\" x=\"{}\" y=\"{:.1f}\" width=\"{}\" height=\"{:.1f}\"/>\n",
                     fill(faint), left, high, right - left, low - high);
}

std::string differences_svg(const Study& study, const Comparison& comparison, const Scores& mouse,
                            const Scores& against, const PlotArea& area) {
  std::vector<double> values = comparison.pair.differences;
  values.push_back(0.0);
  const Axis x(0.0, static_cast<double>(comparison.pair.differences.size()), area.left, area.right, 8, 1.0);
  const Axis y = axis_of(values, area.bottom, area.top, 8);
  const PairedDifference& found = comparison.pair.scores;
  std::string svg = axes_svg(area, x, y, "mazes, sorted by their difference",
                             fmt::format("{} - {} ({})", mouse.name, against.name, study.race.world().traits().unit));
  if (found.count > 1)
    svg += band_svg(area.left, area.right, std::min(y.place(found.interval.low), 1.0 * area.bottom),
                    std::max(y.place(found.interval.high), 1.0 * area.top));  // clipped to the plot
  svg += bars_svg(study, comparison, mouse, against, x, y);
  return svg + line_svg(area.left, y.place(0.0), area.right, y.place(0.0), ink, 1) +
         mean_svg(area.left, area.right, y.place(found.mean));
}

/// The mark of a mouse: a dot for the first one, a ring for the other one.
std::string mark_attributes(bool ring) {
  return ring ? stroke(route) + " stroke-width=\"1.5\"" : fill(to_goal) + " fill-opacity=\"0.8\"";
}

std::string marks_svg(const Study& study, const Scores& scores, bool ring, const Axis& x, const Axis& y) {
  std::string marks;
  for (std::size_t maze = 0; maze < scores.values.size(); ++maze) {
    if (!scores.values[maze]) continue;
    marks += titled("circle",
                    fmt::format("cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"", x.place(*study.race.facts[maze].bound),
                                y.place(*scores.values[maze]), ring ? "3.5" : "2.5"),
                    fmt::format("{}: {} {:.3f}", words_of(study, maze), scores.name, *scores.values[maze]));
  }
  return fmt::format("<g {}>\n{}</g>\n", mark_attributes(ring), marks);
}

std::string bound_svg(double x1, double y1, double x2, double y2) {
  return fmt::format("<path {} stroke-width=\"1.5\" stroke-dasharray=\"2 3\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>\n",
                     stroke(muted), x1, y1, x2, y2);
}

std::string scores_svg(const Study& study, const std::vector<Scores>& mice, const PlotArea& area) {
  std::vector<double> bounds, scores;
  for (const MazeFacts& facts : study.race.facts) bounds.push_back(*facts.bound);
  scores = bounds;
  for (const Scores& mouse : mice)
    for (const auto& score : mouse.values)
      if (score) scores.push_back(*score);
  const Axis x = axis_of(bounds, area.left, area.right, 8), y = axis_of(scores, area.bottom, area.top, 8);
  const auto [low, high] = std::minmax_element(bounds.begin(), bounds.end());
  const std::string_view unit = study.order.race.world->traits().unit;
  std::string svg = axes_svg(area, x, y, fmt::format("bound of the maze ({})", unit),
                             fmt::format("score ({}; lower is better)", unit)) +
                    bound_svg(x.place(*low), y.place(*low), x.place(*high), y.place(*high));
  // Rings first, so that they do not hide the dots.
  for (std::size_t i = mice.size(); i-- > 0;) svg += marks_svg(study, mice[i], i > 0, x, y);
  return svg;
}

std::string sample(const std::string& attributes, std::string_view shape) {
  return fmt::format("<{} {}/>", shape, attributes);
}

void explain_differences(const Comparison& comparison, const Scores& mouse, const Scores& against, Legend& legend) {
  const PairedDifference& found = comparison.pair.scores;
  const auto square = [](const Tone& tone) { return sample(fill(tone), R"(rect y="-6" width="12" height="12")"); };
  legend.add(12, square(to_goal), fmt::format("{} better in {}", mouse.name, counted(found.below, "maze", "mazes")));
  legend.add(12, square(route), fmt::format("{} better in {}", against.name, counted(found.above, "maze", "mazes")));
  legend.add(0, "", fmt::format("equal in {}", counted(found.equal, "maze", "mazes")));
  legend.add(26, mean_svg(0, 26, 0), fmt::format("mean {:+.3f}", found.mean));
  if (found.count > 1)
    legend.add(26, band_svg(0, 26, 6, -6),
               fmt::format("95 % interval of the mean, {:+.3f} to {:+.3f}", found.interval.low, found.interval.high));
}

void explain_scores(const Study& study, const std::vector<Scores>& mice, Legend& legend) {
  for (std::size_t i = 0; i < mice.size(); ++i)
    legend.add(10, sample(mark_attributes(i > 0), fmt::format(R"(circle cx="5" r="{}")", i > 0 ? "3.5" : "2.5")),
               "score of " + mice[i].name);
  legend.add(26, bound_svg(0, 0, 26, 0), "bound: a mouse that knows the maze");
  legend.add(0, "", fmt::format("a failed contest counts {:g}", study.order.race.world->traits().limit_score));
}

/// A row of the picture and the y position of its end, in pixels.
struct Row {
  std::string svg;
  int bottom = 0;
};

std::string row_heading(int top, const std::string& words) {
  return fmt::format("<text x=\"{}\" y=\"{}\" font-weight=\"600\" {}>{}</text>\n", label_room, top + 14, fill(ink),
                     xml_escaped(fitted(words, (two_plots - label_room) / letter_width)));
}

Row comparison_row(const Study& study, const Comparison& comparison, int top) {
  const std::vector<Scores> mice = {scores_of(study, comparison.mouse), scores_of(study, comparison.against)};
  const int plot_top = top + heading, plot_bottom = plot_top + height, second = 2 * label_room + width;
  const PlotArea left = {label_room, plot_top, label_room + width, plot_bottom};
  const PlotArea right = {second, plot_top, second + width, plot_bottom};
  Legend differences({left.left, plot_bottom + below + 8}, left.right),
      scores({right.left, plot_bottom + below + 8}, right.right);
  explain_differences(comparison, mice[0], mice[1], differences);
  explain_scores(study, mice, scores);
  return {row_heading(top, fmt::format("{} against {}", mice[0].name, mice[1].name)) +
              differences_svg(study, comparison, mice[0], mice[1], left) + scores_svg(study, mice, right) +
              differences.svg() + scores.svg(),
          std::max(differences.bottom(), scores.bottom())};
}

/// The row of a study with a single mouse.
Row single_row(const Study& study, int top) {
  const std::vector<Scores> mice = {scores_of(study, 0)};
  const PlotArea area = {label_room, top, label_room + width, top + height};
  Legend scores({area.left, area.bottom + below + 8}, area.right);
  explain_scores(study, mice, scores);
  return {scores_svg(study, mice, area) + scores.svg(), scores.bottom()};
}

}  // namespace

std::string picture_of(const Study& study) {
  const std::vector<Comparison> comparisons =
      study.race.mazes.empty() ? std::vector<Comparison>() : comparisons_of(study);
  const int right = comparisons.empty() ? one_plot : two_plots;
  const std::string title =
      fmt::format("Study of {}{}: {} in {}", fmt::join(study.mice, ", "), study.race.stopped ? ", stopped early" : "",
                  counted(study.race.mazes.size(), "maze", "mazes"), counted(study.folds_done, "fold", "folds"));
  std::string svg = heading_svg({label_room, 32}, right, title), words = "Scores against the bound, maze by maze.";
  int bottom = first_row;
  const auto add = [&](const Row& row) {
    svg += row.svg;
    bottom = row.bottom + margin;
  };
  for (const Comparison& comparison : comparisons) {
    add(comparison_row(study, comparison, bottom));
    words += fmt::format(" {} minus {}: mean difference {:+.3f}.", study.race.mice[comparison.mouse].name,
                         study.race.mice[comparison.against].name, comparison.pair.scores.mean);
  }
  if (study.mice.size() == 1 && !study.race.mazes.empty()) add(single_row(study, bottom));
  return Sheet{right + margin, bottom, title, words, {to_goal}}.with(svg);
}

}  // namespace labmouse
