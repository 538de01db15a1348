#include "labmouse/lab/replays/mms_summary.hpp"

#include <fmt/format.h>

#include "labmouse/lab/bounds/mms_bound.hpp"
#include "labmouse/lab/records/mms_statistics_json.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/last_lines.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// Distance, effective distance and turns of one count, as mms prints them.
std::string count_line(std::string_view name, float distance, float effective, float turns) {
  const auto text = [](float value) { return value < 0 ? std::string("-") : fmt::format("{}", value); };
  return fmt::format("{:<11}{:>11}{:>11}{:>7}\n", name, text(distance), text(effective), text(turns));
}

std::string statistics_text(const MmsStatistics& s) {
  std::string text = fmt::format("{:<11}{:>11}{:>11}{:>7}\n", "", "half steps", "effective", "turns");
  text += count_line("best run", s.best_run_distance, s.best_run_effective_distance, s.best_run_turns);
  text += count_line("current run", s.current_run_distance, s.current_run_effective_distance, s.current_run_turns);
  return text + count_line("total", s.total_distance, s.total_effective_distance, s.total_turns);
}

std::string log_text(const MmsRun& run) {
  if (run.invalid_lines == 0) return "";
  std::string text =
      counted(run.invalid_lines, "line that is not a command, which mms does not answer",
              "lines that are not commands, which mms does not answer") +
      (run.invalid_lines > static_cast<std::int64_t>(run.log.size()) ? "; the first ones are:\n" : ":\n");
  for (const std::string& sentence : run.log) text += "  " + shown(sentence) + "\n";
  return text;
}

std::string errors_text(const MmsRun& run) {
  const std::vector<std::string> lines = last_lines(run.errors);
  if (lines.empty()) return "";
  std::string text = "Last lines on its standard error:\n";
  for (const std::string& line : lines) text += "  | " + shown(line) + "\n";
  return text;
}

}  // namespace

std::string mms_score_line(const std::string& mouse, const NamedMaze& maze, const MmsRun& run) {
  const MmsStatistics& statistics = run.statistics;
  const MmsBound bound = mms_bound_of(maze.maze);
  const std::string_view end = run.outcome == MmsOutcome::never_ended ? "never ended, " : "";
  std::string line = fmt::format("{} in {}: ", mouse, maze.name);
  if (is_cut_short(run.outcome))
    line += fmt::format("{}, no score", name_of(run.outcome));
  else if (statistics.finished)
    line += fmt::format("{}score {:g} = {:g} best run + {:g} total / 10", end, statistics.score, *best_run(statistics),
                        total(statistics));
  else
    line += fmt::format("{}unfinished, score {:g}", end, statistics.score);
  line += bound.score ? fmt::format("; bound {:g}, its run {:g}", *bound.score, *bound.run)
                      : "; the centre cannot be reached";
  return shown(line) + "\n";
}

std::string report_of(const std::string& mouse, const NamedMaze& maze, const MmsRun& run) {
  return statistics_text(run.statistics) + log_text(run) + errors_text(run) +
         shown(fmt::format("{}: {}{}; {}, {:.1f} s in mms", name_of(run.outcome), run.end,
                           run.outcome == MmsOutcome::waiting ? " (use --presses N to press it N times)" : "",
                           counted(run.lines, "line", "lines"), run.clock)) +
         "\n" + mms_score_line(mouse, maze, run);
}

}  // namespace labmouse
