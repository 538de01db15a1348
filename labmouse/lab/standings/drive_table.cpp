#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "labmouse/lab/mice/mouse_names.hpp"
#include "labmouse/lab/standings/drive_report.hpp"
#include "labmouse/lab/standings/drive_standings.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

std::string number(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

double seconds(std::int64_t time) { return static_cast<double>(time) / 1e6; }

std::vector<std::string> mouse_column(const DriveRace& race) {
  std::vector<std::string> specs;
  for (const Contestant& mouse : race.mice) specs.push_back(mouse.name);
  return mouse_names(specs);
}

/// The cells of one line, mouse first.
using Line = std::array<std::string, 11>;

std::string laid_out(const Line& line, std::size_t width) {
  return fmt::format("{:<{}} {:>8} {:>7} {:>13} {:>6} {:>7} {:>7} {:>6} {:>5} {:>6} {:>4}", line[0], width, line[1],
                     line[2], line[3], line[4], line[5], line[6], line[7], line[8], line[9], line[10]);
}

std::string interval_text(const Interval& interval) {
  return fmt::format("{:.2f}{}{:.2f}", interval.low, interval.low < 0 || interval.high < 0 ? " to " : "-",
                     interval.high);
}

Line line_of(const DriveStanding& standing, const std::string& name) {
  const bool spread = standing.mean_score && standing.mazes > 1;  // one maze says nothing of others
  return {name,
          fmt::format("{}/{}", standing.scored, standing.runs),
          number(standing.mean_score, 3),
          spread ? interval_text(standing.interval) : "-",
          number(standing.mean_ratio, 3),
          number(standing.mean_search, 1),
          number(standing.mean_best, 3),
          number(standing.mean_excess ? std::optional(100.0 * *standing.mean_excess) : std::nullopt, 2),
          fmt::format("{}", standing.optimal),
          fmt::format("{}", standing.proven),
          number(standing.mean_starts, 1)};
}

/// Contests without a score, by how they ended: "out of time 3, no way 1".
std::string failures_of(const DriveRace& race, std::size_t mouse) {
  std::map<std::string, int> ends;
  for (const DriveResult& result : race.results)
    if (result.mouse == mouse && counts(race, result) && !result.score.value())
      ++ends[std::string(result.score.outcome == DriveOutcome::forfeit ? name_of(result.reason)
                                                                       : name_of(result.score.outcome))];
  std::string text;
  for (const auto& [end, times] : ends) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", end, times);
  return text;
}

/// "1/30 of "
std::string share_of(int divisor) { return divisor == 1 ? "" : fmt::format("1/{} of ", divisor); }

/// The mean of the bounds, in seconds.
std::optional<double> mean_bound(const DriveRace& race) {
  std::vector<double> bounds;
  for (const DriveBound& bound : race.bounds)
    if (bound.score) bounds.push_back(seconds(*bound.score));
  return bounds.empty() ? std::nullopt : std::optional(mean(bounds));
}

std::string notes_of(const DriveRace& race, const std::vector<std::string>& names) {
  const DriveModel& model = *race.order.model;
  std::string notes = fmt::format(
      "Rules {}: {}. Lower is better; most contests scored first.\nRobot {}, cells of {:g} mm. Search ends where the "
      "first fast "
      "run begins; best runs from rest to the centre.\nBound, {} s on average: the fastest route, driven by a mouse "
      "that knows "
      "the maze but has to search a way there first.\n",
      shown(race.order.rules.name), formula_of(race.order.rules), shown(model.robot.name), model.tables.cell,
      number(mean_bound(race), 3));
  const auto none = std::count_if(race.bounds.begin(), race.bounds.end(), [](const DriveBound& b) { return !b.score; });
  if (none > 0)
    notes += fmt::format("{} in which no mouse could score: not counted.\n",
                         counted(static_cast<int>(none), "maze", "mazes"));
  for (std::size_t mouse = 0; mouse < race.mice.size(); ++mouse)
    if (const std::string failures = failures_of(race, mouse); !failures.empty())
      notes += fmt::format("{} without a score: {}.\n", names[mouse], failures);
  if (race.stopped) {
    const auto done =
        std::count_if(race.results.begin(), race.results.end(), [](const DriveResult& r) { return r.done; });
    notes += fmt::format("Stopped early: {} of {} contests done.\n", done, race.results.size());
  }
  return notes;
}

}  // namespace

std::string formula_of(const DriveRules& rules) {
  std::string text = fmt::format("the best of at most {} in {:g} s, {}", counted(rules.most_runs, "run", "runs"),
                                 seconds(rules.time_limit), rules.gate_to_gate ? "gate to gate" : "rest to centre");
  if (rules.maze_time_divisor > 0)
    text += fmt::format(", plus {}the time in the maze before it", share_of(rules.maze_time_divisor));
  if (rules.untouched_bonus > 0) text += fmt::format(", less {:g} s untouched", seconds(rules.untouched_bonus));
  if (rules.touch_penalty > 0)
    text += fmt::format(", {:g} s for a touch, which never happens here", seconds(rules.touch_penalty));
  return text;
}

std::string table_of(const DriveRace& race, bool colours) {
  const std::vector<std::string> names = mouse_column(race);
  std::size_t width = 5;
  for (const std::string& name : names) width = std::max(width, name.size());
  const char* bold = colours ? "\x1b[1m" : "";
  const char* plain = colours ? "\x1b[0m" : "";
  std::string text = fmt::format("labmouse {}: world of seconds, {}, {}, seed {}\n\n", version(),
                                 counted(static_cast<int>(race.mice.size()), "mouse", "mice"),
                                 counted(static_cast<int>(race.mazes.size()), "maze", "mazes"), race.order.seed);
  const Line first = {"", "", "score", "95 %", "score", "search", "best", "above", "best", "", "runs"};
  const Line second = {"mouse", "scored", "s", "interval", "/bound", "s", "run s", "best%", "runs", "proven", "each"};
  for (const Line& line : {first, second}) text += fmt::format("{}{}{}\n", bold, laid_out(line, width), plain);
  for (const DriveStanding& standing : drive_standings_of(race))
    text += laid_out(line_of(standing, names[standing.mouse]), width) + "\n";
  return text + "\n" + notes_of(race, names);
}

}  // namespace labmouse
