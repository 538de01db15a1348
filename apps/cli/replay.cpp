// labmouse replay: replays a record. labmouse score: prints its score.
#include "replay.hpp"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <thread>

#include "frames.hpp"
#include "labmouse/lab/drives/drive_log.hpp"
#include "labmouse/lab/records/physical_replay.hpp"
#include "records.hpp"

namespace labmouse::cli {
namespace {

struct ScoreOptions {
  std::string file, maze;
};

/// Draws the mouse after each move, and finally the summary.
void watch(const Replay& replay, int delay, const std::string& summary) {
  const Frames frames(replay.subject().maze.maze.size(), 2);
  replay.animate(text_drawer(colours()), [&](const std::string& frame) {
    frames.show(frame);
    if (frames.moving()) std::this_thread::sleep_for(std::chrono::milliseconds(delay));
  });
  frames.show(summary);
}

/// Saves all ticks of a contest in the physical world.
void save_log(const std::string& path, const std::string& text) {
  const ReadDriveRecordResult read = read_drive_record(text);
  if (!read.file || !read.file->physical || read.file->physical->notes.by_failure_model)
    throw UsageError(
        "error: --log: this contest simulated no sensors and motors; one that does is "
        "`labmouse run flood contest-01 --world physical --log run.csv`");
  std::vector<LoggedTick> ticks;
  drive_again(*read.file, 0, &ticks);
  const DriveModel& model = *read.file->model;
  save(path, log_text(ticks, labmouse::Field(*read.file->maze, model.tables.cell), *model.robot.hardware));
}

int replay_file(const ReplayOptions& options) {
  expect_outputs({{"--svg", options.svg, FileKind::picture}, {"--log", options.log, FileKind::log}});
  return show_replay(options, load_record_text(options.file));
}

/// A score is printed only if the record matches its maze, so it is replayed first.
int score_file(const ScoreOptions& options) {
  const auto replay = open_record(options.file, load_record_text(options.file), options.maze);
  if (replay) print(replay->result());
  return replay ? exit_good : exit_finding;
}

}  // namespace

void add_log(Command& command, std::string& log) {
  command
      .add_option(
          "--log", log,
          "Save the sensor readings, duties and true position of each ms as CSV, if a controller drove the mouse")
      ->type_name("FILE");
}

void add_watch(Command& command, bool& watch, int& delay) {
  command.add_flag("--watch", watch, "Draw every step");
  command.add_option("--delay", delay, "Milliseconds to show each step")
      ->check(in_range(0, 60'000))
      ->capture_default_str();
}

int show_replay(const ReplayOptions& options, const std::string& text) {
  const auto replay = options.has_parts ? fresh_drive_replay(text) : open_record(options.file, text, options.maze);
  if (!replay) return exit_finding;
  if (!options.log.empty()) save_log(options.log, text);
  const std::string summary = replay->summary(text_drawer(colours()));
  if (options.watch)
    watch(*replay, options.delay, summary);
  else
    print(summary);
  if (options.explain.wanted) {
    const std::string reasons = replay->reasons(options.explain.candidates);
    print("\n" + (reasons.empty() ? options.no_reasons + "\n" : reasons));
  }
  if (!options.svg.empty()) save(options.svg, replay->picture());
  return exit_good;
}

void add_replay(Command& app, int& exit) {
  auto options = std::make_shared<ReplayOptions>();
  Command* command = app.add_subcommand("replay", "Replay a record and check that it matches its maze");
  command->add_option("file", options->file, "Record")->required()->type_name("FILE");
  add_record_maze(*command, options->maze);
  add_explain(*command, options->explain);
  add_watch(*command, options->watch, options->delay);
  command->add_option("--svg", options->svg, "Save a picture")->type_name("FILE");
  add_log(*command, options->log);
  command->footer("Example: labmouse run certify capstone-1 --record walk.jsonl && labmouse replay walk.jsonl --watch");
  command->callback([options, &exit] { exit = replay_file(*options); });
}

void add_score(Command& app, int& exit) {
  auto options = std::make_shared<ScoreOptions>();
  Command* command = app.add_subcommand("score", "Check that a record matches its maze, and print its score");
  command->add_option("file", options->file, "Record")->required()->type_name("FILE");
  add_record_maze(*command, options->maze);
  command->footer("Example: labmouse run certify capstone-1 --record walk.jsonl && labmouse score walk.jsonl");
  command->callback([options, &exit] { exit = score_file(*options); });
}

}  // namespace labmouse::cli
