#include "labmouse/mouse/explorer.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "labmouse/mouse/drive/drive_fields.hpp"
#include "labmouse/mouse/drive/search_clock.hpp"

namespace labmouse {

namespace {

std::unique_ptr<DriveFields> fields_for(const Briefing& briefing) {
  if (!briefing.in_seconds() || briefing.drive.fields != nullptr) return nullptr;
  return std::make_unique<DriveFields>(DriveFields::in_own_memory(briefing.size, *briefing.drive.model));
}

}  // namespace

Explorer::Explorer(const Briefing& briefing)
    : fields_(fields_for(briefing)),
      briefing_(briefing),
      knowledge_(briefing.size, briefing.sight),
      pose_(briefing.start),
      to_goal_(briefing.size, briefing.motion) {
  assert(briefing.size.contains(briefing.start.cell) && !briefing.goals.empty());
  visited_.insert(pose_.cell);
  if (!briefing.in_seconds()) return;
  if (fields_) briefing_.drive.fields = fields_.get();
  clock_ = std::make_unique<SearchClock>(briefing_);
  goal_entered_ = briefing.goals.contains(pose_.cell);
}

Explorer::~Explorer() = default;

Action Explorer::decide(const Sighting& seen) {
  if (!knowledge_.learn(pose_, seen)) return Action::forfeit(ForfeitReason::contradiction);
  seen_ = seen;
  return decide();
}

Action Explorer::decide() {
  Action action = racing_ ? race() : explore();
  if (must_go_home_before(action)) action = Action::reset();
  perform(action);
  ++steps_;
  return action;
}

Action Explorer::consider(const Belief& belief, const SearchPlace& place, std::int64_t time) {
  knowledge_ = belief.view();
  pose_ = place.pose;
  at_rest_ = place.at_rest;
  clock_->set(time);
  if (std::exchange(version_, belief.version()) != belief.version()) {
    // The goal that it had entered may have been another cell, or the way there none.
    to_goal_.fill(knowledge_.open(), briefing_.goals);
    goal_entered_ = goal_entered_ && to_goal_.reaches(briefing_.start.cell);
    renew();
  }
  if (!racing_) arrive();
  // Whether the next step leads into a goal it will know when it is there.
  const bool entered = goal_entered_;
  const Action action = decide();
  goal_entered_ = entered;
  return action;
}

void Explorer::show(const Pose& pose, const Sighting& seen) { static_cast<void>(knowledge_.learn(pose, seen)); }

void Explorer::carried(std::int64_t clock) {
  pose_ = briefing_.start;
  at_rest_ = true;
  racing_ = false;
  if (clock_) clock_->set(clock);
}

void Explorer::searches_at(double pace) {
  if (clock_) clock_->set_pace(pace);
}

std::span<const Counter> Explorer::counters() const {
  return clock_ ? std::span<const Counter>(counters_) : std::span<const Counter>();
}

std::int64_t Explorer::time_left() const { return clock_->time_left(); }

bool Explorer::must_go_home_before(const Action& action) {
  return clock_ && !racing_ && goal_entered_ && action.kind == Action::Kind::step &&
         clock_->is_too_late_after(action, knowledge_, place());
}

Action Explorer::race() {
  if (clock_) return Action::forfeit(ForfeitReason::finished);
  to_goal_.fill(knowledge_.open(), briefing_.goals);
  return step_along(to_goal_, knowledge_.open(), pose_);
}

void Explorer::perform(const Action& action) {
  switch (action.kind) {
    case Action::Kind::step:
      move(action);
      assert(briefing_.size.contains(pose_.cell));
      if (!racing_) arrive();
      break;
    case Action::Kind::reset:
      assert(goal_entered_ && !racing_);
      pose_ = briefing_.start;
      racing_ = at_rest_ = true;
      break;
    case Action::Kind::forfeit:
      break;
  }
}

void Explorer::arrive() {
  visited_.insert(pose_.cell);
  if (briefing_.goals.contains(pose_.cell)) goal_entered_ = true;
}

void Explorer::move(const Action& step) {
  if (!clock_) {
    pose_ = after(pose_, step);
    return;
  }
  clock_->count(knowledge_, place(), step);
  const SearchPlace next = after_search(place(), step);
  pose_ = next.pose;
  at_rest_ = next.at_rest;
}

}  // namespace labmouse
