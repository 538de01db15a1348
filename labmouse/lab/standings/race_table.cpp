#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "labmouse/lab/standings/mouse_column.hpp"
#include "labmouse/lab/standings/race_notes.hpp"
#include "labmouse/lab/standings/race_report.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

std::string number(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

/// One maze says nothing of others, so it has no interval.
std::string interval_text(const Standing& standing) {
  if (standing.mazes < 2) return "-";
  return fmt::format("{:.1f}-{:.1f}", standing.interval.low, standing.interval.high);
}

/// The cells of one line, mouse first. With the built-in mice a line fits into 90 columns.
using Line = std::array<std::string, 10>;

std::string laid_out(const Line& line, std::size_t width) {
  return fmt::format("{:<{}} {:>8} {:>7} {:>11} {:>7} {:>6} {:>5} {:>6} {:>5} {:>5}", line[0], width, line[1], line[2],
                     line[3], line[4], line[5], line[6], line[7], line[8], line[9]);
}

Line line_of(const std::string& name, const Standing& standing) {
  const bool ran = standing.runs > 0;
  return {name,
          fmt::format("{}/{}", standing.solved, standing.runs),
          number(standing.penalised_mean, 3),
          interval_text(standing),
          number(standing.mean_score, 3),
          number(standing.mean_ratio, 3),
          number(standing.mean_exploration, 1),
          number(standing.mean_speed_over_optimum, 2),
          ran ? fmt::format("{:.1f}", 100.0 * standing.optimal_share) : "-",
          ran ? fmt::format("{:.{}f}", standing.microseconds_per_decision,
                            standing.microseconds_per_decision < 100.0 ? 2 : 0)
              : "-"};
}

}  // namespace

std::string table_of(const Race& race, bool colours) {
  const MouseColumn names(race);
  const char* bold = colours ? "\x1b[1m" : "";
  const char* plain = colours ? "\x1b[0m" : "";
  const int budget = race.order.rules.budget;
  std::string text = fmt::format("labmouse {}: {}, {}, seed {}{}\n\n", version(),
                                 counted(static_cast<int>(race.mice.size()), "mouse", "mice"),
                                 counted(static_cast<int>(race.mazes.size()), "maze", "mazes"), race.order.seed,
                                 budget == Rules().budget ? "" : fmt::format(", budget {}", budget));
  const Line first = {"", "", "score", "95 %", "score", "score", "expl.", "speed", "best", "us a"};
  const Line second = {"mouse", "solved", "all", "interval", "solved", "/bound", "steps", "+steps", "runs%", "step"};
  for (const Line& line : {first, second}) text += fmt::format("{}{}{}\n", bold, laid_out(line, names.width), plain);
  for (const Standing& standing : standings_of(race))
    text += laid_out(line_of(names.of[standing.mouse], standing), names.width) + "\n";
  return text + "\n" + notes_of(race);
}

std::string shares_of(const Race& race) {
  const MouseColumn names(race);
  const auto percent = [](const std::optional<double>& share) {
    return share ? fmt::format("{:.1f}", 100.0 * *share) : std::string("-");
  };
  std::string text =
      fmt::format("Exploration: percent of the reachable cells, mean over all contests\n{:<{}} {:>11} {:>8}\n", "mouse",
                  names.width, "discovered%", "visited%");
  for (const Standing& standing : standings_of(race))
    text += fmt::format("{:<{}} {:>11} {:>8}\n", names.of[standing.mouse], names.width,
                        percent(standing.mean_discovered), percent(standing.mean_visited));
  return text;
}

std::string worst_of(const Race& race, int count) {
  std::string text;
  for (const Standing& standing : standings_of(race)) {
    std::vector<std::pair<double, std::size_t>> losses;
    const auto scores = scores_by_maze(race, standing.mouse);
    for (std::size_t maze = 0; maze < scores.size(); ++maze)
      if (scores[maze]) losses.emplace_back(*scores[maze] - *race.bounds[maze].score, maze);
    std::stable_sort(losses.begin(), losses.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    losses.resize(std::min(losses.size(), static_cast<std::size_t>(count)));
    text += fmt::format("{}: worst mazes\n", race.mice[standing.mouse].name);
    for (const auto& [loss, maze] : losses)
      text += fmt::format("  {:>8.3f} = bound {:.3f} + {:.3f}  {}\n", *scores[maze], *race.bounds[maze].score, loss,
                          shown(race.mazes[maze].name));
  }
  return text;
}

}  // namespace labmouse
