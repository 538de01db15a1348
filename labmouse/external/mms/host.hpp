// mms, the simulator, as a function: one line of a mouse in, the reply out. No window, no process, no clock.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>

#include "labmouse/external/mms/canvas.hpp"
#include "labmouse/external/mms/command.hpp"
#include "labmouse/external/mms/half_pose.hpp"
#include "labmouse/external/mms/statistics.hpp"
#include "labmouse/maze/maze.hpp"

namespace labmouse {

struct MmsOptions {
  /// Whether a line that mms would not answer ends the run.
  bool strict = false;
  /// How often somebody presses Reset for a mouse that waits for it: that asked `wasReset` 100 times with nothing
  /// between.
  int presses = 0;
  /// After which a mouse is taken to go on for ever: simulated seconds, and lines. No program was met that needs a
  /// tenth of either.
  int most_seconds = 3'600;
  int most_lines = 10'000'000;
};

/// What a line did, for records and for watching.
struct MmsEvent {
  std::string_view line;   ///< as the mouse wrote it
  std::string_view reply;  ///< empty where there is none
  HalfPose pose;           ///< after it
  double clock = 0;        ///< simulated time after it, in seconds, at mms's default speed
};

/// The simulator with one mouse in one maze, from its start to its end. No time passes in it.
class MmsHost {
 public:
  MmsHost(const Maze& maze, const MmsOptions& options);

  /// Obeys one line, without its end; appends the reply with its end, if the line has one. Does nothing once the mouse
  /// does not go on.
  void obey(std::string_view line, std::string& replies);

  /// Called after each line that moved or turned the mouse, put it back, or drew something. Called for no others.
  void on_event(std::function<void(const MmsEvent&)> listener);

  /// False once a strict run had a bad line, the mouse waits for a Reset that nobody presses, or it is endless.
  bool goes_on() const;
  /// Whether the mouse waits for Reset: it asked 100 times with nothing between, and no presses are left.
  bool waits() const;
  /// Whether the mouse took all the simulated time or all the lines that it may.
  bool is_endless() const;
  /// Presses the Reset button.
  void press_reset();

  const HalfPose& pose() const { return pose_; }
  const MmsStatistics& statistics() const { return ledger_.statistics(); }
  const MmsLedger& ledger() const { return ledger_; }
  const MmsCanvas& canvas() const { return canvas_; }
  /// Simulated seconds since the start: what mms needs for the moves and turns at its default speed.
  double clock() const;
  /// Lines so far, answered or not.
  std::int64_t lines() const { return lines_; }
  /// Lines that mms would log as invalid, and what was wrong with the first 100 of them, one sentence each:
  /// "line 12: 'turnRight 2' has no reply: turnRight takes no argument".
  std::int64_t invalid_lines() const { return invalid_lines_; }
  const std::deque<std::string>& log() const { return log_; }

 private:
  bool obey(const MmsCommand& command, std::string& replies);
  bool sees_wall(Compass direction, std::int64_t half_steps) const;
  std::int64_t move(std::int64_t half_steps);
  void turn(int eighths);
  void arrive();
  bool draw(const MmsCommand& command);
  void draw(Cell cell, const MmsCommand& command);
  void note_question();
  void log_invalid(std::string_view line, const std::string& problem);

  Maze maze_;
  CellSet goals_;
  MmsOptions options_;
  HalfPose pose_;
  MmsLedger ledger_;
  MmsCanvas canvas_;
  bool was_reset_ = false;
  int questions_ = 0;  ///< for Reset, denied, with nothing between
  double work_ = 0;
  std::int64_t lines_ = 0, invalid_lines_ = 0;
  std::deque<std::string> log_;
  std::function<void(const MmsEvent&)> listener_;
};

}  // namespace labmouse
