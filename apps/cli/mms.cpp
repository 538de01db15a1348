// labmouse mms: runs one program that was written for mms, without mms.
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <optional>
#include <thread>

#include "command.hpp"
#include "contests.hpp"
#include "external.hpp"
#include "frames.hpp"
#include "labmouse/external/mms/run.hpp"
#include "labmouse/lab/mms/mms_world.hpp"
#include "labmouse/lab/records/mms_record.hpp"
#include "labmouse/lab/replays/mms_drawing.hpp"
#include "labmouse/lab/replays/mms_summary.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "worlds.hpp"

namespace labmouse::cli {
namespace {

struct MmsCommandOptions {
  std::string command, maze, record;
  WorldSettings given;
  ExternalOptions external_mice;
  bool watch = false;
  double speed = 5.0;
};

/// Draws the mouse after each move, for the simulated time of the move divided by `speed`.
class Watching {
 public:
  Watching(const Maze& maze, double speed, const std::atomic<bool>& stop)
      : maze_(maze), speed_(speed), stop_(stop), frames_(maze.size(), 1) {}

  void tell(const MmsEvent& event, const MmsHost& host) {
    // Drawing takes no simulated time; it is shown with the next move.
    if (event.pose == pose_) return;
    pose_ = event.pose;
    frames_.show(mms_frame(maze_, event, host, text_drawer(colours())));
    if (frames_.moving()) pause(event.clock - clock_);
    clock_ = event.clock;
  }

  void show_end(const std::string& drawing) const { frames_.show(drawing); }

 private:
  void pause(double simulated) const {
    using namespace std::chrono_literals;
    const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(simulated / speed_);
    // Short waits, so that Ctrl-C takes effect at once.
    while (!stop_.load() && std::chrono::steady_clock::now() < until)
      std::this_thread::sleep_for(
          std::min<std::chrono::duration<double>>(until - std::chrono::steady_clock::now(), 50ms));
  }

  const Maze& maze_;
  double speed_;
  const std::atomic<bool>& stop_;
  Frames frames_;
  HalfPose pose_;
  double clock_ = 0;
};

MmsRun host(const MmsCommandOptions& options, const NamedMaze& maze) {
  const Interruptible interruptible;
  ExternalOptions external_mice = options.external_mice;
  external_mice.stop = &interruptible.stopped();
  for (const std::string& file : {options.maze, options.record}) external_mice.hidden->add(file);
  const std::vector<Contestant> mice = find_contestants({"mms:" + options.command}, external_mice);
  const Contestant& mouse = mice.front();
  MmsOptions mms;
  if (const std::string error = choose(mms_rows, options.given, mms); !error.empty()) throw UsageError(error);
  std::optional<MmsRecorder> recorder;
  std::optional<Watching> watching;
  if (!options.record.empty()) recorder.emplace(mouse.name, maze);
  if (options.watch) watching.emplace(maze.maze, options.speed, interruptible.stopped());
  std::function<void(const MmsEvent&, const MmsHost&)> listener;
  if (recorder || watching)
    listener = [&](const MmsEvent& event, const MmsHost& now) {
      if (recorder) recorder->add(event);
      if (watching) watching->tell(event, now);
    };
  MmsRun run = run_mms(std::get<MmsProgram>(mouse.kind).launch, maze.maze, mms, listener);
  if (recorder) save(options.record, recorder->finish(run));
  const std::string drawing = mms_drawing_of(maze.maze, run.canvas, run.pose, text_drawer(colours()));
  if (watching)
    watching->show_end(drawing);
  else
    print(drawing);
  print(freedom_note(mice));
  return run;
}

int mms(const MmsCommandOptions& options) {
  expect_outputs({{"--record", options.record, FileKind::record}});
  const NamedMaze maze = find_maze(options.maze, {});
  const MmsRun run = host(options, maze);
  print(report_of(options.command, maze, run));
  if (run.outcome == MmsOutcome::interrupted) return exit_interrupted();
  return run.outcome == MmsOutcome::complete ? exit_good : exit_finding;
}

}  // namespace

void add_mms(Command& app, int& exit) {
  auto options = std::make_shared<MmsCommandOptions>();
  Command* command = app.add_subcommand("mms", "Run a program written for mms in one maze");
  command
      ->add_option("command", options->command,
                   "Command that starts the program, split into words as in mms; no shell is used")
      ->required()
      ->type_name("COMMAND");
  command->add_option("maze,--maze", options->maze, "Maze file or built-in maze")->required()->type_name("MAZE");
  for (const auto& row : mms_rows)
    add_setting(*command, row.setting, std::string(row.setting.meaning), std::string(row.setting.default_value),
                options->given);
  command->add_flag("--watch", options->watch, "Draw the mouse after each move");
  Option* speed = command->add_option("--speed", options->speed, "Watch it at this multiple of mms's default speed")
                      ->type_name("TIMES")
                      ->check(finite_number())
                      ->check(in_range(0.01, 1e6))
                      ->capture_default_str();
  command->add_option("--record", options->record, "Save a record of what the program did")->type_name("FILE");
  add_external_options(*command, options->external_mice);
  command->footer("Example: labmouse mms 'python3 mouse.py' --maze contest-05 --speed 10");
  command->callback([options, speed, &exit] {
    options->watch = options->watch || speed->count() > 0;
    exit = mms(*options);
  });
}

}  // namespace labmouse::cli
