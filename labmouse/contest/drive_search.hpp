// The moving part of a contest in seconds: a mouse that searches, its clock, and what has been seen.
#pragma once

#include "labmouse/contest/drive_record.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/drive/search_motion.hpp"
#include "labmouse/mouse/knowledge.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/sighting.hpp"

namespace labmouse {

/// What a mouse in that pose reads that looks so many cells far.
Sighting look(const Maze& maze, Pose pose, int sight);

/// Makes the moves of searches and of ways home, and writes them and the walls that they show into the record.
class SearchDriver {
 public:
  /// At rest at the start, where it reads the walls; all must outlive it.
  SearchDriver(const Maze& maze, const DriveModel& model, DriveRecord& record);

  /// Makes a move in the last run of the record, edge by edge with a reading at each; show(pose, seen) is told all of
  /// them but the last. False, with what was made so far, where it is no move, or leads through a wall not known to be
  /// open.
  template <class Show>
  bool move(const Action& action, bool replanned, Show show) {
    if (!is_search_step(place_, action)) return false;
    if (action.movement == 0) {
      make(action, replanned);
      return true;
    }
    Action part = Action::step(action.rotation, 1);
    for (int edge = 0; edge < action.movement; ++edge) {
      if (edge > 0) show(place_.pose, seen_);
      if (!known_.open().contains(wall_at(place_.pose.cell, after_search(place_, part).pose.heading))) return false;
      make(part, replanned && edge == 0);
      part = Action::step(0, 1);
    }
    return true;
  }

  /// Notes when the mouse would stand in the middle of a goal, where a search ends at its edge.
  void stop_search();
  /// Drives a run by other means: to that place at that time.
  void put(const SearchPlace& place, MazeTime clock);

  const SearchPlace& place() const { return place_; }
  SearchPlace start() const { return {{maze_.start(), maze_.start_heading()}, true}; }
  const Sighting& seen() const { return seen_; }
  MazeTime clock() const { return clock_; }
  const Knowledge& known() const { return known_; }
  bool goal_entered() const { return goal_entered_; }

 private:
  void make(const Action& action, bool replanned);
  void note_gates(const Action& action, MazeTime begin);
  void read();

  const Maze& maze_;
  const DriveModel& model_;
  DriveRecord& record_;
  Knowledge known_;
  SearchPlace place_;
  Sighting seen_;
  MazeTime clock_ = 0;
  bool goal_entered_;
};

}  // namespace labmouse
