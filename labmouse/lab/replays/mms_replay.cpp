#include "labmouse/lab/replays/mms_replay.hpp"

namespace labmouse {
namespace {

/// Takes from the record the end of the run, and all that a replay does not give.
void take_end(const MmsRecordFile& file, MmsRun& run) {
  run.outcome = MmsOutcome::interrupted;
  run.end = "the record breaks off";
  if (!file.end) return;
  run.outcome = mms_outcome_of(file.end->outcome).value_or(MmsOutcome::interrupted);
  run.end = file.end->end;
  run.statistics = file.end->statistics;
  run.lines = file.end->lines;
  run.invalid_lines = file.end->invalid_lines;
  run.log = file.end->log;
  run.errors = file.end->errors;
  run.clock = file.end->clock;
}

}  // namespace

MmsReplay replay_of(const MmsRecordFile& file) {
  MmsReplay played;
  played.run.canvas = MmsCanvas(file.maze->size());
  MmsStatistics at_best_run;
  played.disagreement = replay(file, [&](std::size_t i, const MmsHost& host) {
    const RecordedMmsEvent& event = file.events[i];
    played.walk.add({event.line, event.reply, event.pose, event.clock});
    if (i + 1 < file.events.size()) return;
    at_best_run = host.ledger().at_best_run();
    played.run.canvas = host.canvas();
    played.run.pose = host.pose();
    played.run.statistics = host.statistics();
    played.run.clock = host.clock();
  });
  take_end(file, played.run);
  // For a run that never ended, earlier versions recorded the statistics at its end and not at its best run.
  if (played.run.outcome == MmsOutcome::never_ended && file.left_out == 0) played.run.statistics = at_best_run;
  return played;
}

}  // namespace labmouse
