#include <fmt/format.h>

#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/lab/text/errors_text.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

std::string number(const std::optional<MazeTime>& time) {
  return time ? fmt::format("{:.3f}", in_seconds(*time)) : "-";
}
std::string number(DriveTime time) { return time < no_time ? fmt::format("{:.3f}", in_seconds(time)) : "-"; }

/// From gate to gate; of a run of laps, its fastest lap.
std::optional<MazeTime> between_gates(const DriveRun& run) {
  if (const auto lap = fastest_lap(run, run.end)) return lap->time;
  return run.gate_in && run.gate_out ? std::optional(*run.gate_in - *run.gate_out) : std::nullopt;
}

std::string run_line(const DriveRun& run, std::size_t index) {
  return fmt::format("{:>3}  {:<6} {:>9.3f} {:>9.3f} {:>8} {:>8} {:>8} {:>8}\n", index + 1, name_of(run.kind),
                     in_seconds(run.begin), in_seconds(run.end), number(between_gates(run)),
                     number(run.centre ? std::optional(*run.centre - run.begin) : std::nullopt), number(run.known),
                     number(run.possible));
}

/// "48.214 of 100 marks = 9/12 dead ends * 18/28 steps"
std::string mark_words(const DeadEndCount& count, const DriveRules& rules) {
  return fmt::format("{:.3f} of {} marks = {}/{} dead ends * {}/{} steps",
                     rules.marks - in_seconds(marks_lost(count, rules)), rules.marks, count.seen, count.all,
                     count.fewest_steps, count.steps);
}

/// "8.123 s = 5.123 s gate to gate + 3.000 s of 90.000 s in the maze"
std::string score_words(const DriveScore& score, const DriveRecord& record, const DriveRules& rules) {
  const DriveRunScore& best = score.runs[*score.best];
  if (rules.counts == Counted::dead_end)
    return mark_words(*record.runs[best.run].dead_ends, rules) + fmt::format(" in run {}", best.run + 1);
  const auto time = rules.gate_to_gate ? best.gate_to_gate : best.rest_to_centre;
  std::string words = fmt::format("{:.3f} s = {:.3f} s {}", in_seconds(best.value), in_seconds(*time),
                                  rules.gate_to_gate ? "gate to gate" : "rest to centre");
  if (rules.maze_time_divisor > 0)
    words += fmt::format(" + {:.3f} s / {}", in_seconds(record.runs[best.run].begin), rules.maze_time_divisor);
  if (best.bonus > 0) words += fmt::format(" - {:.3f} s untouched", in_seconds(best.bonus));
  if (best.penalty > 0) words += fmt::format(" + {:.3f} s touched", in_seconds(best.penalty));
  if (best.lap > 0) words += fmt::format(" in lap {}", best.lap);
  return words + fmt::format("{} run {}", best.lap > 0 ? " of" : " in", best.run + 1);
}

}  // namespace

std::string value_text(MazeTime value, const DriveRules& rules, int digits) {
  return fmt::format("{:.{}f} {}", in_seconds(value), digits, unit_of(rules.counts));
}

std::string result_line(const DriveRecordFile& file) {
  const DriveRecord& record = file.record;
  const DriveScore result = score(record, file.rules);
  std::string line =
      fmt::format("{} in {}, {}, {}{}: ", file.mouse, file.maze_name, file.model->robot.name, file.rules.name,
                  file.physical ? ", " + text_of(file.physical->conditions.errors) : "");
  if (result.best)
    line += score_words(result, record, file.rules);
  else
    line += file.ended ? std::string(name_of(record.outcome)) : "the record breaks off";
  if (record.outcome == DriveOutcome::forfeit) line += fmt::format(" ({})", name_of(record.reason));
  return shown(line);
}

std::string summary_of(const DriveRecordFile& file) {
  std::string text = fmt::format("{:>3}  {:<6} {:>9} {:>9} {:>8} {:>8} {:>8} {:>8}\n", "run", "", "begin s", "end s",
                                 "gates", "centre", "known", "possible");
  for (std::size_t i = 0; i < file.record.runs.size(); ++i) {
    std::string line = run_line(file.record.runs[i], i);
    if (file.physical && i < file.physical->notes.ends.size())
      line.insert(line.size() - 1, fmt::format("  {}", name_of(file.physical->notes.ends[i])));
    text += line;
  }
  return text + result_line(file) + "\n";
}

}  // namespace labmouse
