// mms, the simulator, as a function: one line of a mouse in, the reply out. No window, no process, no clock.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>

#include "labmouse/guests/mms/canvas.hpp"
#include "labmouse/guests/mms/half_pose.hpp"
#include "labmouse/guests/mms/statistics.hpp"
#include "labmouse/maze/maze.hpp"

namespace labmouse {

struct MmsOptions {
  /// Whether a line that mms would not answer ends the run.
  bool strict = false;
  /// How often somebody presses Reset for a mouse that waits for it: that asked `wasReset` 100 times with nothing between.
  int presses = 0;
};

/// What a line did, for records and for watching.
struct MmsEvent {
  std::string_view line;    ///< as the mouse wrote it
  std::string_view reply;   ///< empty where there is none
  HalfPose pose;            ///< after it
  double clock = 0;         ///< simulated time after it, in seconds, at mms's default speed
};

/// The simulator with one mouse in one maze, from its start to its end.
class MmsHost {
 public:
  MmsHost(const Maze& maze, const MmsOptions& options);

  /// Obeys one line, without its end; appends the reply with its end, if the line has one.
  void obey(std::string_view line, std::string& replies);

  /// Called after each line that moved or turned the mouse, put it back, or drew something. Called for no others.
  void on_event(std::function<void(const MmsEvent&)> listener);

  /// False once a strict run had a bad line, or the mouse waits for a Reset that nobody presses.
  bool goes_on() const;
  /// Whether the mouse waits for Reset: it asked 100 times with nothing between.
  bool waits() const;
  /// Presses the Reset button.
  void press_reset();

  const HalfPose& pose() const;
  const MmsStatistics& statistics() const;
  const MmsCanvas& canvas() const;
  /// Simulated seconds since the start.
  double clock() const;
  /// Lines so far, answered or not.
  std::int64_t lines() const;
  /// Lines that mms would log as invalid, and what was wrong with the first 100 of them, one sentence each:
  /// "line 12: 'turnRight 2' has no reply: turnRight takes no argument".
  std::int64_t invalid_lines() const;
  const std::deque<std::string>& log() const;
};

}  // namespace labmouse
