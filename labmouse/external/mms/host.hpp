// The mms simulator as a library: it takes lines of a mouse, and returns the replies. It has no window, no process and
// no real time.
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
  /// Whether an invalid line ends the run; otherwise it is only logged.
  bool strict = false;
  /// How often Reset is pressed for a mouse that waits for it, that is, asked `wasReset` 100 times in a row.
  int presses = 0;
  /// Limits of simulated seconds and lines after which a mouse counts as endless. Known programs need less than a tenth
  /// of either.
  int most_seconds = 3'600;
  int most_lines = 10'000'000;
};

/// Effect of a line, for records and displays.
struct MmsEvent {
  std::string_view line;   ///< as the mouse wrote it
  std::string_view reply;  ///< empty if there is none
  HalfPose pose;           ///< after it
  double clock = 0;        ///< simulated time after it, in seconds, at mms's default speed
};

/// What the simulator takes of a maze: whether sides of its cells are open, and where the mouse starts and ends.
struct MmsMaze {
  Size size;
  std::function<bool(Cell, Heading)> is_open;  ///< as Maze::is_open(); the border is closed
  HalfPose start;
  CellSet goals;
};

/// The simulator with one mouse in one maze. It does not wait: time is only counted.
class MmsHost {
 public:
  /// With the start and the goals of mms.
  MmsHost(const Maze& maze, const MmsOptions& options);
  MmsHost(MmsMaze maze, const MmsOptions& options);

  /// Obeys one line, without its end; appends the reply with its end, if the line has one. Does nothing if goes_on() is
  /// false.
  void obey(std::string_view line, std::string& replies);

  /// Sets a listener for lines that moved, turned or reset the mouse, or drew something.
  void on_event(std::function<void(const MmsEvent&)> listener);

  /// False after an invalid line in a strict run, if the mouse waits for a Reset with no presses left, or if it is
  /// endless.
  bool goes_on() const;
  /// Whether the mouse waits for Reset: it asked 100 times in a row, and no presses are left.
  bool waits() const;
  /// Whether the limit of simulated time or of lines is reached.
  bool is_endless() const;
  /// Presses the Reset button.
  void press_reset();
  /// Puts the mouse there: for a mouse that is driven, and that got less far than it was sent.
  void put(const HalfPose& pose) { pose_ = pose; }

  const HalfPose& pose() const { return pose_; }
  const MmsStatistics& statistics() const { return ledger_.statistics(); }
  const MmsLedger& ledger() const { return ledger_; }
  const MmsCanvas& canvas() const { return canvas_; }
  /// Simulated seconds since the start: the time that mms takes for the moves and turns at its default speed.
  double clock() const;
  /// Lines so far, answered or not.
  std::int64_t lines() const { return lines_; }
  /// Lines that mms would log as invalid, and what was wrong with the first 100 of them, one sentence each:
  /// "line 12: 'turnRight 2' has no reply: turnRight takes no argument".
  std::int64_t invalid_lines() const { return invalid_lines_; }
  const std::deque<std::string>& log() const { return log_; }

 private:
  bool obey(const MmsCommand& command, std::string& replies);
  bool is_blocked(HalfPlace place, Compass direction) const;
  bool sees_wall(Compass direction, std::int64_t half_steps) const;
  std::int64_t move(std::int64_t half_steps);
  void turn(int eighths);
  void arrive();
  bool draw(const MmsCommand& command);
  void draw(Cell cell, const MmsCommand& command);
  void note_question();
  void log_invalid(std::string_view line, const std::string& problem);

  MmsMaze maze_;
  MmsOptions options_;
  HalfPose pose_;
  MmsLedger ledger_;
  MmsCanvas canvas_;
  bool was_reset_ = false;
  int questions_ = 0;  ///< `wasReset` in a row with the reply false
  double work_ = 0;
  std::int64_t lines_ = 0, invalid_lines_ = 0;
  std::deque<std::string> log_;
  std::function<void(const MmsEvent&)> listener_;
};

}  // namespace labmouse
