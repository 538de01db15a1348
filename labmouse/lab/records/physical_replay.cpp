#include "labmouse/lab/records/physical_replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "labmouse/contest/code_contest.hpp"
#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/drive_score.hpp"
#include "labmouse/contest/physical.hpp"
#include "labmouse/contest/script.hpp"
#include "labmouse/contest/taped_code.hpp"
#include "labmouse/lab/failure_rates/failure_file.hpp"
#include "labmouse/lab/records/drive_json.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// The record with its marks of planning cleared: a replay does not plan.
DriveRecordFile unplanned(DriveRecordFile file) {
  file.record.replanned = 0;
  for (DriveRun& run : file.record.runs)
    for (SearchMove& move : run.moves) move.replanned = false;
  return file;
}

template <class Item>
void cut_to(std::vector<Item>& list, const std::vector<Item>& shorter) {
  list.resize(std::min(list.size(), shorter.size()));
}

/// Cuts a re-run to the length of a record that breaks off; a run that breaks off counts as ended there.
void cut_runs_like(DriveRecord& record, const DriveRecord& kept, bool last_breaks_off) {
  cut_to(record.runs, kept.runs);
  if (last_breaks_off && !kept.runs.empty() && record.runs.size() == kept.runs.size()) {
    DriveRun& last = record.runs.back();
    const DriveRun& was = kept.runs.back();
    cut_to(last.moves, was.moves);
    cut_to(last.route.segments, was.route.segments);
    last.end = was.end;
    last.gate_out = was.gate_out;
    last.gate_in = was.gate_in;
    last.centre = was.centre;
    last.laps = was.laps;
    last.dead_ends = was.dead_ends;
  }
  cut_to(record.walls, kept.walls);
  record.outcome = kept.outcome;
  record.reason = kept.reason;
  record.decisions = kept.decisions;
}

void cut_like(DriveRecordFile& again, const DriveRecordFile& file) {
  PhysicalNotes& notes = again.physical->notes;
  const PhysicalNotes& kept = file.physical->notes;
  cut_runs_like(again.record, file.record, kept.ends.size() < file.record.runs.size());
  cut_to(notes.actions, kept.actions);
  cut_to(notes.tape, kept.tape);
  cut_to(notes.ends, kept.ends);
  cut_to(notes.looks, kept.looks);
  cut_to(notes.touches, kept.touches);
  cut_to(notes.trace, kept.trace);
  notes.carried = kept.carried;
  notes.wrong_walls = kept.wrong_walls;
  notes.contradictions = kept.contradictions;
  notes.severity = kept.severity;
}

std::string_view next_line(std::string_view& text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(text.size(), line.size() + 1));
  return line;
}

std::string shortened(std::string_view line) {
  constexpr std::size_t longest = 120;
  return line.size() <= longest ? std::string(line) : std::string(line.substr(0, longest)) + "...";
}

std::string wrong_tables(const DriveRecordFile& file) {
  if (file.tables_hash == file.model->tables.hash) return "";
  return fmt::format("the hash of the robot's tables is {}; recomputed, it is {}", hash_text(file.tables_hash),
                     hash_text(file.model->tables.hash));
}

/// The first line in which the records differ as files.
std::string first_difference(const DriveRecordFile& file, const DriveRecordFile& again) {
  const std::string recorded = write_drive_record(unplanned(file)), replayed = write_drive_record(unplanned(again));
  std::string_view a = recorded, b = replayed;
  for (int line = 1; !a.empty() || !b.empty(); ++line) {
    const std::string_view was = next_line(a), is = next_line(b);
    if (was == is) continue;
    return fmt::format("line {}: recorded as {}; driven again, {}", line, shortened(was), shortened(is));
  }
  return "";
}

/// What the record says otherwise than the re-run: a line, or the score of a whole record, which is computed when a
/// record is written.
std::string disagreement(const DriveRecordFile& file, const DriveRecordFile& again) {
  if (std::string wrong = first_difference(file, again); !wrong.empty() || !file.ended) return wrong;
  const DriveScore scored = score(again.record, file.rules);
  const auto best = scored.best ? std::optional(scored.runs[*scored.best]) : std::nullopt;
  return best == file.recorded_score ? "" : "the recorded score is not that of the contest, driven again";
}

std::optional<FailureFile> rates_behind(const PhysicalPart& part) {
  return builtin_rates_of(part.failure_rates, part.rates_hash);
}

}  // namespace

PhysicalRecord drive_again(const DriveRecordFile& file, int trace_every, std::vector<LoggedTick>* log) {
  PhysicalConditions conditions = file.physical->conditions;
  conditions.trace_every = trace_every;
  conditions.log = log;
  if (const auto& tape = file.physical->notes.tape; !tape.empty()) {
    TapedCode code(tape, file.record.reason);
    return drive_by_code(*file.maze, file.rules, *file.model, conditions, file.seed, code);
  }
  std::vector<double> paces;
  for (const DriveRun& run : file.record.runs) paces.push_back(run.pace);
  Script script(file.maze->size(), file.physical->notes.actions, std::move(paces));
  if (file.physical->notes.by_failure_model) {
    const FailureRates failure_rates = rates_of(*rates_behind(*file.physical));
    return drive_with_failures(*file.maze, file.rules, *file.model, conditions, failure_rates, file.seed, script);
  }
  return drive_physically(*file.maze, file.rules, *file.model, conditions, file.seed, script);
}

std::string replay_physically(const DriveRecordFile& file) {
  const bool by_failure_model = file.physical->notes.by_failure_model;
  if (const int edition = by_failure_model ? failures_edition : physical_edition; file.physical->edition != edition)
    return fmt::format(
        "it was driven in edition {} of the {} world; this version has edition {}, so it can be "
        "shown and not driven again",
        file.physical->edition, world_of(file), edition);
  if (by_failure_model && !rates_behind(*file.physical))
    return fmt::format(
        "it was run with the failure rates {} ({}), which are not built in; it can be shown and not driven again",
        shown(file.physical->failure_rates), shown(file.physical->rates_hash));
  if (file.physical->notes.foreign_parts)
    return "parts of its controller were somebody's own, and the record lacks what they answered; it can be shown and "
           "not driven again";
  if (std::string wrong = wrong_tables(file); !wrong.empty()) return wrong;
  DriveRecordFile again = file;
  PhysicalRecord driven = drive_again(file, file.physical->conditions.trace_every);
  again.record = std::move(driven.drive);
  again.physical->notes = std::move(driven);
  if (!file.ended) cut_like(again, file);
  return disagreement(file, again);
}

std::string replay_laps(const DriveRecordFile& file) {
  if (std::string wrong = wrong_tables(file); !wrong.empty()) return wrong;
  DriveRecordFile again = file;
  Script script(file.maze->size(), {});
  again.record = drive(*file.maze, file.rules, *file.model, script);
  if (!file.ended) cut_runs_like(again.record, file.record, file.record.walls.empty());
  return disagreement(file, again);
}

}  // namespace labmouse
