#include "labmouse/lab/standings/race_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "labmouse/lab/standings/common_fields.hpp"
#include "labmouse/lab/standings/maze_scores.hpp"
#include "labmouse/lab/standings/mouse_column.hpp"
#include "labmouse/lab/standings/mouse_figures.hpp"
#include "labmouse/lab/standings/race_notes.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

std::vector<const Column*> columns_of(const Race& race, bool all) {
  std::vector<const Column*> columns;
  for (const Column& column : race.world().traits().fields->columns)
    if (all || !column.rare) columns.push_back(&column);
  return columns;
}

}  // namespace

std::string heading_of(const Race& race) {
  return fmt::format("labmouse {}: {}{}, {}, seed {}{}", version(), race.world().title(),
                     counted(race.mice.size(), "mouse", "mice"), counted(race.mazes.size(), "maze", "mazes"),
                     race.order.seed, race.world().traits().heading);
}

std::vector<std::vector<std::string>> cells_of(const Race& race, bool all) {
  const MouseColumn names(race);
  const std::vector<const Column*> columns = columns_of(race, all);
  std::vector<std::vector<std::string>> rows = {{""}, {"mouse"}};
  for (const Column* column : columns) {
    rows[0].emplace_back(column->first);
    rows[1].emplace_back(second_line_of(*column, race.world()));
  }
  for (const Standing& standing : standings_of(race)) {
    std::vector<std::string>& row = rows.emplace_back(1, names.of[standing.mouse]);
    for (const Column* column : columns) row.push_back(column->text(race, standing));
  }
  return rows;
}

std::string table_of(const Race& race, bool colours, bool all) {
  return heading_of(race) + "\n\n" + leaderboard_of(race, colours, all) + "\n" + notes_of(race);
}

std::string leaderboard_of(const Race& race, bool colours, bool all) {
  const std::vector<const Column*> columns = columns_of(race, all);
  const std::size_t width = MouseColumn(race).width;
  const auto standings = standings_of(race);
  const auto best = std::find_if(standings.begin(), standings.end(), [&](const Standing& standing) {
    return !race.mice[standing.mouse].reference && standing.finished > 0;
  });
  std::vector<std::size_t> widths;
  for (const Column* column : columns)
    widths.push_back(std::max<std::size_t>(column->width, second_line_of(*column, race.world()).size()));
  std::string text;
  std::ptrdiff_t line_number = -2;  // two lines of headings
  for (const std::vector<std::string>& row : cells_of(race, all)) {
    // Padded by characters, which fmt counts, and not by bytes.
    std::string line = fmt::format("{:<{}}", row.front(), width);
    for (std::size_t i = 0; i < columns.size(); ++i) line += fmt::format(" {:>{}}", row[i + 1], widths[i]);
    const bool heading = line_number < 0;
    const bool is_best = !heading && standings.size() > 1 && line_number == best - standings.begin();
    ++line_number;
    text +=
        colours && (heading || is_best) ? fmt::format("\x1b[{}m{}\x1b[0m\n", heading ? "1" : "32", line) : line + "\n";
  }
  return text;
}

std::string shares_of(const Race& race) {
  const MouseColumn names(race);
  const auto percent = [](const std::optional<double>& share) {
    return columns::number(share ? std::optional(100.0 * *share) : std::nullopt, 1);
  };
  std::string text =
      fmt::format("Search: percent of the reachable cells, mean over all contests\n{:<{}} {:>11} {:>8}\n", "mouse",
                  names.width, "discovered%", "visited%");
  for (const Standing& standing : standings_of(race))
    text += fmt::format("{:<{}} {:>11} {:>8}\n", names.of[standing.mouse], names.width,
                        percent(mean_of_all(race, standing, discovered_share)),
                        percent(mean_of_all(race, standing, visited_share)));
  return text;
}

std::string worst_of(const Race& race, int count) {
  const World& world = race.world();
  std::string text = world.traits().failure_score ? ""
                                                  : fmt::format("Here a failed contest counts {:g} {}.\n",
                                                                world.traits().limit_score, world.traits().unit);
  for (const Standing& standing : standings_of(race)) {
    std::vector<std::pair<double, std::size_t>> losses;
    std::vector<std::optional<double>> scores;
    for (const MazeScores& maze : maze_scores(race, standing.mouse)) scores.push_back(maze.mean());
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
