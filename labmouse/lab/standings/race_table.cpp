#include "labmouse/lab/standings/race_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/standings/common_fields.hpp"
#include "labmouse/lab/standings/mouse_column.hpp"
#include "labmouse/lab/standings/mouse_figures.hpp"
#include "labmouse/lab/standings/race_notes.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// One line of the table: the mouse, and a text for each column, all flush right.
template <class TextOf>
std::string line_of(const Race& race, const std::string& mouse, std::size_t width, TextOf text_of) {
  // Padded by characters, which fmt counts, and not by bytes.
  std::string line = fmt::format("{:<{}}", mouse, width);
  for (const Column& column : race.world().fields().columns)
    line += fmt::format(" {:>{}}", text_of(column), column.width);
  return line;
}

std::string heading_of(const Race& race) {
  return fmt::format("labmouse {}: {}{}, {}, seed {}{}\n\n", version(), race.world().title(),
                     counted(static_cast<int>(race.mice.size()), "mouse", "mice"),
                     counted(static_cast<int>(race.mazes.size()), "maze", "mazes"), race.order.seed,
                     race.world().heading());
}

}  // namespace

std::string table_of(const Race& race, bool colours) {
  return heading_of(race) + leaderboard_of(race, colours) + "\n" + notes_of(race);
}

std::string leaderboard_of(const Race& race, bool colours) {
  const MouseColumn names(race);
  const char* bold = colours ? "\x1b[1m" : "";
  const char* plain = colours ? "\x1b[0m" : "";
  std::string text;
  const auto first = line_of(race, "", names.width, [](const Column& column) { return column.first; });
  const auto second = line_of(race, "mouse", names.width, [](const Column& column) { return column.second; });
  for (const std::string& line : {first, second}) text += fmt::format("{}{}{}\n", bold, line, plain);
  for (const Standing& standing : standings_of(race))
    text += line_of(race, names.of[standing.mouse], names.width,
                    [&](const Column& column) { return column.text(race, standing); }) +
            "\n";
  return text;
}

std::string shares_of(const Race& race) {
  const MouseColumn names(race);
  const auto percent = [](const std::optional<double>& share) {
    return columns::number(share ? std::optional(100.0 * *share) : std::nullopt, 1);
  };
  std::string text =
      fmt::format("Exploration: percent of the reachable cells, mean over all contests\n{:<{}} {:>11} {:>8}\n", "mouse",
                  names.width, "discovered%", "visited%");
  for (const Standing& standing : standings_of(race))
    text += fmt::format("{:<{}} {:>11} {:>8}\n", names.of[standing.mouse], names.width,
                        percent(mean_of_all(race, standing, discovered_share)),
                        percent(mean_of_all(race, standing, visited_share)));
  return text;
}

std::string worst_of(const Race& race, int count) {
  std::string text;
  for (const Standing& standing : standings_of(race)) {
    std::vector<std::pair<double, std::size_t>> losses;
    const auto scores = scores_by_maze(race, standing.mouse);
    for (std::size_t maze = 0; maze < scores.size(); ++maze)
      if (scores[maze]) losses.emplace_back(*scores[maze] - *race.facts[maze].bound, maze);
    std::stable_sort(losses.begin(), losses.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    losses.resize(std::min(losses.size(), static_cast<std::size_t>(count)));
    text += fmt::format("{}: worst mazes\n", race.mice[standing.mouse].name);
    for (const auto& [loss, maze] : losses)
      text += fmt::format("  {:>8.3f} = bound {:.3f} + {:.3f}  {}\n", *scores[maze], *race.facts[maze].bound, loss,
                          shown(race.mazes[maze].name));
  }
  return text;
}

}  // namespace labmouse
