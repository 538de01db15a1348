// The common base of labmouse's own strategies for the worlds in seconds (see driving_strategy.hpp). It tracks the
// place of the mouse and the time, learns from readings or takes over a map, and goes home in time. The strategy
// decides where to search.
#pragma once

#include <cstdint>
#include <memory>

#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/driving_strategy.hpp"
#include "labmouse/mouse/route.hpp"

namespace labmouse {

class DriveFields;
class SearchClock;

/// Base class of strategies for the worlds in seconds, which implement explore(). It goes home when another step would
/// leave too little time for that, and has no more to do after a speed run.
class DrivingExplorer : public DrivingStrategy {
 public:
  /// Takes all memory that it will need, and that of its fields if the briefing provides none.
  /// @param briefing in seconds, with the start inside the maze and at least one goal. What it points to must outlive
  ///   the mouse.
  explicit DrivingExplorer(const Briefing& briefing);
  ~DrivingExplorer() override;

  Action decide(const Sighting& seen) final;
  Action consider(const LogOddsMap& map, const SearchPlace& place, std::int64_t time) final;
  void show(const Pose& pose, const Sighting& seen) final;
  void carried(std::int64_t time) final;
  void searches_at(double pace) final;
  const Knowledge& knowledge() const final { return knowledge_; }
  std::int64_t plans() const final { return plans_; }

 protected:
  /// Chooses the next action of the search.
  /// @return a step as search_motion.hpp lists them, through walls known to be open; a reset, to go home and make speed
  ///   runs, if goal_entered(); or a forfeit. Once a goal was entered, a step that would leave too little time to go
  ///   home and run becomes a reset.
  virtual Action explore() = 0;

  /// Called when known walls have changed: the next explore() must plan anew.
  virtual void renew() {}

  /// The briefing. Its `drive.fields` are set, and all parts of a strategy share them.
  const Briefing& briefing() const { return briefing_; }
  /// The cell and heading that the mouse has between two moves.
  const Pose& pose() const { return place_.pose; }
  /// The pose, and whether the mouse is at rest.
  const SearchPlace& place() const { return place_; }
  /// Whether a step of the search has ended in a goal, so that a reset is allowed.
  bool goal_entered() const { return goal_entered_; }
  /// What is left of the time in the maze.
  /// @return microseconds; below 0 if the time limit has passed.
  std::int64_t time_left() const;

  /// Counts a new plan, for plans().
  void count_plan() { ++plans_; }

 private:
  Action decide();
  bool must_go_home_before(const Action& action);
  void perform(const Action& action);
  void arrive();

  std::unique_ptr<DriveFields> fields_;  ///< null if the briefing provides them
  Briefing briefing_;
  Knowledge knowledge_;
  SearchPlace place_;
  DistanceField to_goal_;
  std::unique_ptr<SearchClock> clock_;
  std::int64_t plans_ = 0;
  int version_ = 0;  ///< of the map at the last call
  bool goal_entered_;
  bool racing_ = false;
};

}  // namespace labmouse
