#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "labmouse/lab/mice/mouse_names.hpp"
#include "labmouse/lab/standings/mms_report.hpp"
#include "labmouse/lab/standings/mms_standings.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

std::string number(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

std::vector<std::string> names_of(const MmsRace& race) {
  std::vector<std::string> specs;
  for (const MmsMouse& mouse : race.mice) specs.push_back(mouse.name);
  return mouse_names(specs);
}

/// The cells of one line, mouse first.
using Line = std::array<std::string, 10>;

std::string laid_out(const Line& line, std::size_t width) {
  // Padded by its characters, which fmt counts, and not by its bytes.
  return fmt::format("{:<{}} {:>7} {:>6} {:>11} {:>6} {:>6} {:>6} {:>6} {:>6} {:>6}", line[0], width, line[1], line[2],
                     line[3], line[4], line[5], line[6], line[7], line[8], line[9]);
}

Line line_of(const MmsStanding& standing, const std::string& name) {
  const bool spread = standing.runs > 1;                      // one maze says nothing of others
  const int digits = standing.interval.high >= 1000 ? 0 : 1;  // what its column has room for
  return {name,
          fmt::format("{}/{}", standing.solved, standing.runs),
          number(standing.mean_score, 1),
          spread ? fmt::format("{:.{}f}-{:.{}f}", standing.interval.low, digits, standing.interval.high, digits) : "-",
          number(standing.mean_solved_score, 1),
          number(standing.mean_ratio, 2),
          number(standing.mean_best_run, 1),
          number(standing.mean_run_ratio, 2),
          number(standing.mean_total, 0),
          number(standing.mean_seconds, 2)};
}

/// How often a mouse ended otherwise than by exit code 0: "hung 3, failed 1"; empty where it did not.
std::string failures_of(const MmsStanding& standing) {
  std::string text;
  for (std::size_t outcome = 1; outcome < standing.outcomes.size(); ++outcome)
    if (const int times = standing.outcomes[outcome]; times > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name_of(static_cast<MmsOutcome>(outcome)), times);
  return text;
}

/// The first of its runs that is as asked; null where none is.
template <class Wanted>
const MmsResult* first_run(const MmsRace& race, std::size_t mouse, Wanted wanted) {
  const auto found = std::find_if(race.results.begin(), race.results.end(), [&](const MmsResult& result) {
    return result.mouse == mouse && result.done && wanted(result.run);
  });
  return found == race.results.end() ? nullptr : &*found;
}

/// How many runs of each mouse ended in another way than by exit code 0, how the first of them did, and what it said
/// last.
std::string failures_of(const MmsRace& race, const std::vector<MmsStanding>& standings,
                        const std::vector<std::string>& names) {
  std::string text;
  for (const MmsStanding& standing : standings) {
    const auto* first =
        first_run(race, standing.mouse, [](const MmsRun& run) { return run.outcome != MmsOutcome::complete; });
    if (first == nullptr) continue;
    text += fmt::format("  {}: {}; first in {}: {}\n", names[standing.mouse], failures_of(standing),
                        shown(race.mazes[first->maze].name), shown(first->run.end));
    for (const std::string& line : last_lines(first->run.errors)) text += "    | " + shown(line) + "\n";
  }
  return text.empty() ? "" : "Ended otherwise than by exit code 0 (the score counts all the same):\n" + text;
}

std::string invalid_lines_of(const MmsRace& race, const std::vector<MmsStanding>& standings,
                             const std::vector<std::string>& names) {
  std::string text;
  for (const MmsStanding& standing : standings) {
    const auto* first = first_run(race, standing.mouse, [](const MmsRun& run) { return run.invalid_lines > 0; });
    if (first == nullptr) continue;
    text +=
        fmt::format("  {}: {} of {}; first in {}: {}\n", names[standing.mouse], standing.invalid_lines, standing.lines,
                    shown(race.mazes[first->maze].name), first->run.log.empty() ? "" : shown(first->run.log.front()));
  }
  return text.empty() ? "" : "Lines that are no command, which mms does not answer:\n" + text;
}

/// Whether mms starts or ends elsewhere than the file says.
bool marked_otherwise(const NamedMaze& maze) {
  return maze.maze.start() != Cell(0, 0) || maze.maze.goals() != mms_goals(maze.maze.size());
}

std::string mazes_of(const MmsRace& race) {
  std::string text;
  const auto otherwise = static_cast<int>(std::count_if(race.mazes.begin(), race.mazes.end(), marked_otherwise));
  if (otherwise > 0)
    text += fmt::format("mms starts at (0,0) and its goal is the centre, other than {} {}.\n",
                        counted(otherwise, "maze", "mazes"), otherwise == 1 ? "says" : "say");
  const auto closed = [&](std::size_t maze) { return !race.bounds[maze].run; };
  int routeless = 0;
  std::string first;
  for (std::size_t maze = 0; maze < race.mazes.size(); ++maze)
    if (closed(maze) && routeless++ == 0) first = shown(race.mazes[maze].name);
  if (routeless > 0)
    text += fmt::format("Left out of all means: {} whose centre cannot be reached ({}{}).\n",
                        counted(routeless, "maze", "mazes"), first, routeless > 1 ? ", ..." : "");
  return text;
}

std::string notes_of(const MmsRace& race, const std::vector<MmsStanding>& standings,
                     const std::vector<std::string>& names) {
  std::string notes =
      "Score, as mms counts: effective distance + turns of the best run + a tenth of all\n"
      "effective distance and turns (total). Unsolved counts 2000. Lower is better.\n";
  notes += mazes_of(race) + failures_of(race, standings, names) + invalid_lines_of(race, standings, names);
  if (race.stopped) {
    const auto done =
        std::count_if(race.results.begin(), race.results.end(), [](const MmsResult& r) { return r.done; });
    notes += fmt::format("Stopped early: {} of {} runs done.\n", done, race.results.size());
  }
  return notes;
}

}  // namespace

std::string table_of(const MmsRace& race, bool colours) {
  const std::vector<std::string> names = names_of(race);
  std::size_t width = 5;
  for (const std::string& name : names) width = std::max(width, name.size());
  const char* bold = colours ? "\x1b[1m" : "";
  const char* plain = colours ? "\x1b[0m" : "";
  std::string text = fmt::format("labmouse {}: world of mms, {}, {}\n\n", version(),
                                 counted(static_cast<int>(race.mice.size()), "mouse", "mice"),
                                 counted(static_cast<int>(race.mazes.size()), "maze", "mazes"));
  const Line first = {"", "", "score", "95 %", "score", "score", "best", "run", "", "s a"};
  const Line second = {"mouse", "solved", "all", "interval", "solved", "/bound", "run", "/bound", "total", "run"};
  for (const Line& line : {first, second}) text += fmt::format("{}{}{}\n", bold, laid_out(line, width), plain);
  const std::vector<MmsStanding> standings = mms_standings_of(race);
  for (const MmsStanding& standing : standings)
    text += laid_out(line_of(standing, names[standing.mouse]), width) + "\n";
  return text + "\n" + notes_of(race, standings, names);
}

}  // namespace labmouse
