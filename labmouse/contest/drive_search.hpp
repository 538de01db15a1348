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
      make(action, replanned, show);
      return true;
    }
    Action part = Action::step(action.rotation, 1);
    for (int edge = 0; edge < action.movement; edge += part.movement, part.rotation = 0) {
      if (edge > 0) show(place_.pose, seen_);
      part.movement = cells_at_once(part.rotation, action.movement - edge);
      const Heading heading = after_search(place_, part).pose.heading;
      for (int cell = 0; cell < part.movement; ++cell)
        if (!known_.open().contains(wall_at(neighbour(place_.pose.cell, heading, cell), heading))) return false;
      make(part, replanned && edge == 0, show);
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
  /// Over how many edges the next part of a move leads: one, or those of a dash.
  int cells_at_once(int rotation, int most) const;
  template <class Show>
  void make(const Action& action, bool replanned, Show show) {
    const Pose from = place_.pose;
    const MazeTime begin = clock_;
    for (int edge = 1; edge < action.movement; ++edge) {
      pass(Action::step(0, 1), begin + model_.search.dash_part(action.movement, edge));
      show(place_.pose, seen_);
    }
    const bool dash = action.movement > 1;
    const Action last = dash ? Action::step(0, 1) : action;
    pass(last, begin + (dash ? model_.search.dash(action.movement) : search_time(model_.search, place_, action)));
    record_.runs.back().moves.push_back({begin, clock_, from, action, place_.pose, replanned});
  }
  void pass(const Action& action, MazeTime end);
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
