#include "labmouse/contest/code_contest.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "labmouse/contest/clocked_body.hpp"
#include "labmouse/contest/drive_score.hpp"

namespace labmouse {
namespace {

/// Below this speed a mouse counts as at rest.
constexpr double rest_speed = 10.0;  // mm/s

class CodeContest {
 public:
  CodeContest(const Maze& maze, const DriveRules& rules, const DriveModel& model, const PhysicalConditions& conditions,
              std::uint64_t seed, ControllerCode& code)
      : maze_(maze),
        rules_(rules),
        handling_(conditions.handling),
        code_(code),
        body_(maze, model, conditions, seed, rules.time_limit, record_) {}

  PhysicalRecord hold() {
    body_.put_at_start();
    rest_ = body_.clock();
    while (!over_) tick();
    DriveRecord& drive = record_.drive;
    if (score(drive, rules_).best)
      drive.outcome = DriveOutcome::finished;
    else if (drive.outcome != DriveOutcome::forfeit)
      drive.outcome = DriveOutcome::out_of_time;
    return std::move(record_);
  }

 private:
  using Kind = DriveRun::Kind;

  void tick() {
    const ControllerTick said = code_.tick(body_.sense());
    record_.tape.push_back(said);
    if (said.word == ControllerWord::give_up) return give_up();
    if (said.word == ControllerWord::carry) return carry(RunEnd::given_up);
    if (said.word == ControllerWord::fast) next_ = Kind::speed;
    if (said.word == ControllerWord::goal) goal_said_ = true;
    const bool goes_on = body_.step(said.drive());
    body_.trace(std::nullopt);
    if (body_.crashed()) return carry(body_.cause());
    follow();
    if (!goes_on) end_contest(RunEnd::out_of_time);
  }

  DriveRun& run() { return record_.drive.runs.back(); }

  /// Begins and ends runs by the position of the true mouse.
  void follow() {
    const bool home = body_.cell() == maze_.start();
    const bool rests = home && std::abs(body_.body().motion().speed) < rest_speed;
    if (!running_ && !home) begin_run();
    if (!running_) {
      if (rests) rest_ = body_.clock();
      return;
    }
    const bool on_the_way_home = run().kind == Kind::home;
    if (!on_the_way_home) body_.note_gates(run());
    if (!on_the_way_home && goal_said_ && run().gate_in)
      turn_home();
    else if (rests)
      end_run(on_the_way_home ? RunEnd::done : RunEnd::given_up);
  }

  /// Begins a run: the mouse has left the start cell.
  void begin_run() {
    if (starts_of(record_.drive) >= rules_.most_runs) {
      over_ = true;
      return;
    }
    open_run(std::exchange(next_, Kind::search), rest_);
    goal_said_ = false;
  }

  void open_run(Kind kind, MazeTime begin) {
    DriveRun run;
    run.kind = kind;
    run.begin = begin;
    run.touched = record_.carried > 0;
    record_.drive.runs.push_back(std::move(run));
    record_.ends.push_back(RunEnd::done);
    running_ = true;
  }

  void turn_home() {
    end_run(RunEnd::done);
    if (!over_) open_run(Kind::home, body_.clock());
  }

  /// Ends the run. It counts as done if a goal was entered; but a search that crashes later counts as crashed.
  void end_run(RunEnd end) {
    const bool goal = run().gate_in && (run().kind == Kind::speed || !is_crash(end));
    record_.ends.back() = goal ? RunEnd::done : end;
    run().end = rest_ = body_.clock();
    running_ = false;
    if (run().kind != Kind::home && starts_of(record_.drive) >= rules_.most_runs) over_ = true;
  }

  void end_contest(RunEnd end) {
    if (running_) end_run(end);
    over_ = true;
  }

  void carry(RunEnd end) {
    const bool crashed = body_.crashed();
    if (running_) end_run(end);
    over_ = over_ || starts_of(record_.drive) >= rules_.most_runs;
    if (over_) return;
    ++record_.carried;
    // At least a tick, so that the contest ends even if a mouse asks to be carried all the time.
    body_.wait(std::max<MazeTime>(handling_, 1000));
    over_ = body_.out_of_time();
    body_.put_at_start();
    rest_ = body_.clock();
    if (!over_) code_.carried(crashed);
  }

  void give_up() {
    record_.drive.outcome = DriveOutcome::forfeit;
    record_.drive.reason = code_.reason();
    end_contest(RunEnd::given_up);
  }

  const Maze& maze_;
  const DriveRules& rules_;
  MazeTime handling_;
  ControllerCode& code_;
  PhysicalRecord record_;
  ClockedBody body_;
  bool running_ = false, over_ = false;
  Kind next_ = Kind::search;
  MazeTime rest_ = 0;       ///< when it last stood in the start cell
  bool goal_said_ = false;  ///< whether the program has ended this run
};

}  // namespace

ControllerBriefing controller_briefing(const Maze& maze, const DriveRules& rules, const DriveModel& model,
                                       const PhysicalConditions& conditions, std::uint64_t seed) {
  return {maze.size(), {maze.start(), maze.start_heading()}, maze.goals(), model, rules, conditions.handling, seed};
}

PhysicalRecord drive_by_code(const Maze& maze, const DriveRules& rules, const DriveModel& model,
                             const PhysicalConditions& conditions, std::uint64_t seed, ControllerCode& code) {
  return CodeContest(maze, rules, model, conditions, seed, code).hold();
}

}  // namespace labmouse
