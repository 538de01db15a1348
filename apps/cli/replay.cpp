// labmouse replay: plays a record again. labmouse score: what it is worth.
#include "replay.hpp"

#include <fmt/format.h>

#include <memory>

#include "labmouse/lab/mms/mms_drawing.hpp"
#include "labmouse/lab/mms/mms_summary.hpp"
#include "labmouse/lab/pictures/drive_picture.hpp"
#include "labmouse/lab/records/drive_story.hpp"
#include "labmouse/lab/steps/steps_files.hpp"
#include "records.hpp"
#include "walk.hpp"

namespace labmouse::cli {
namespace {

struct ScoreOptions {
  const Command* command = nullptr;
  std::string file, maze;
};

int replay_in_seconds(const ReplayOptions& options, const std::string& text) {
  refuse_options(*options.command, {"--maze", "--watch", "--delay", "--candidates"}, "a record in seconds");
  const auto file = load_drive_record(options.file, text);
  if (!file) return exit_finding;
  print(summary_of(*file));
  if (options.explain.wanted) print("\n" + story_of(*file));
  if (!options.svg.empty()) save(options.svg, draw_contest(*file));
  return exit_good;
}

int replay_in_mms(const ReplayOptions& options, const std::string& text) {
  refuse_options(*options.command, {"--maze", "--watch", "--delay", "--explain", "--candidates"}, "a record of mms");
  const auto record = load_mms_record(options.file, text);
  if (!record) return exit_finding;
  const MmsRun& run = record->replay.run;
  print(mms_drawing_of(*record->file.maze, run.canvas, run.pose));
  print(report_of(record->file.mouse, record->maze(), run));
  if (!options.svg.empty())
    save(options.svg, draw_mms_run(record->file.mouse, record->maze(), run, record->replay.walk));
  return exit_good;
}

int replay_file(const ReplayOptions& options) {
  expect_outputs({{"the record", options.file, Output::Kind::input}, {"--svg", options.svg}});
  return replay_text(options, load_record_text(options.file));
}

/// A record's score counts only if it could have happened, so it is played first.
int score_file(const ScoreOptions& options) {
  const std::string text = load_record_text(options.file);
  if (is_drive_record(text)) {
    refuse_options(*options.command, {"--maze"}, "a record in seconds");
    const auto file = load_drive_record(options.file, text);
    if (file) print(result_line(*file) + "\n");
    return file ? exit_good : exit_finding;
  }
  if (is_mms_record(text)) {
    refuse_options(*options.command, {"--maze"}, "a record of mms");
    const auto record = load_mms_record(options.file, text);
    if (record) print(mms_score_line(record->file.mouse, record->maze(), record->replay.run));
    return record ? exit_good : exit_finding;
  }
  RecordFile file = load_record(options.file, text, options.maze);
  if (!re_enact(options.file, file)) return exit_finding;
  print(result_line(file) + "\n");
  return exit_good;
}

}  // namespace

void add_watch(Command& command, bool& watch, int& delay) {
  command.add_flag("--watch", watch, "Draw every step");
  command.add_option("--delay", delay, "Milliseconds to show each step")
      ->check(in_range(0, 60'000))
      ->capture_default_str();
}

int replay_text(const ReplayOptions& options, const std::string& text) {
  if (is_drive_record(text)) return replay_in_seconds(options, text);
  if (is_mms_record(text)) return replay_in_mms(options, text);
  RecordFile file = load_record(options.file, text, options.maze);
  if (!re_enact(options.file, file)) return exit_finding;
  if (options.watch)
    watch(file, options.delay);
  else
    print(summary_of(file));
  if (const std::string checked = checked_line(file); !checked.empty()) print(checked + "\n");
  explain(file, options.explain,
          "The record has no reasons; to keep them, use `labmouse run` with --explain and --record.");
  if (!options.svg.empty()) save(options.svg, picture_of(file));
  return exit_good;
}

void add_replay(Command& app, int& exit) {
  auto options = std::make_shared<ReplayOptions>();
  Command* command = app.add_subcommand("replay", "Replay a record and check that it matches its maze");
  options->command = command;
  command->add_option("file", options->file, "Record")->required()->type_name("FILE");
  add_record_maze(*command, options->maze);
  add_explain(*command, options->explain);
  add_watch(*command, options->watch, options->delay);
  command->add_option("--svg", options->svg, "Save a picture")->type_name("FILE");
  command->footer("Example: labmouse run certify capstone-1 --record walk.jsonl && labmouse replay walk.jsonl --watch");
  command->callback([options, &exit] { exit = replay_file(*options); });
}

void add_score(Command& app, int& exit) {
  auto options = std::make_shared<ScoreOptions>();
  Command* command = app.add_subcommand("score", "Check that a record matches its maze, and print its score");
  options->command = command;
  command->add_option("file", options->file, "Record")->required()->type_name("FILE");
  add_record_maze(*command, options->maze);
  command->footer("Example: labmouse score walk.jsonl");
  command->callback([options, &exit] { exit = score_file(*options); });
}

}  // namespace labmouse::cli
