// The clock of a searching mouse, which adds up the times of its steps.
#pragma once

#include <cstdint>

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/drive/drive_fields.hpp"
#include "labmouse/mouse/knowledge.hpp"

namespace labmouse {

/// Counts the time of a search, and decides when the mouse must go home to run in time.
class SearchClock {
 public:
  /// For a briefing in seconds, with fields.
  explicit SearchClock(const Briefing& briefing);

  void count(const Knowledge& knowledge, const SearchPlace& from, const Action& step) {
    time_ += time_of(step, knowledge, from);
  }

  /// Sets the search pace, as a share of the usual one.
  void set_pace(double pace) { pace_ = pace; }
  /// Sets the time to that of the contest's clock, where the mouse gets it.
  void set(std::int64_t time) { time_ = time; }

  /// Whether after that step the way home and the fastest known run no longer fit into the time, whatever the step
  /// shows. False if no run is known. Uses the briefing's fields.
  bool is_too_late_after(const Action& step, const Knowledge& knowledge, const SearchPlace& place);

  /// What is left of the time in the maze, in microseconds.
  std::int64_t time_left() const { return time_limit_ - time_; }

 private:
  std::int64_t time_of(const Action& step, const Knowledge& knowledge, const SearchPlace& from) const {
    return slowed(search_time(search_, from, step, search_.dashes() ? knowledge.known_cells() : CellSet()));
  }

  std::int64_t slowed(std::int64_t time) const { return at_pace(time, pace_); }

  Pose start_;
  CellSet goals_;
  SearchDrive search_;
  double pace_;  ///< of a search, as a share of the usual one
  std::int64_t time_limit_;
  std::int64_t time_ = 0;
  DriveTime run_ = no_time;  ///< of the last planned run, which needs these walls to be open
  WallSet run_walls_;
  DriveFields& fields_;
};

}  // namespace labmouse
