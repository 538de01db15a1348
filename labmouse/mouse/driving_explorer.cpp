#include "labmouse/mouse/driving_explorer.hpp"

#include <cassert>
#include <utility>

#include "labmouse/mouse/drive/drive_fields.hpp"
#include "labmouse/mouse/drive/search_clock.hpp"

namespace labmouse {
namespace {

std::unique_ptr<DriveFields> fields_for(const Briefing& briefing) {
  if (briefing.drive.fields != nullptr) return nullptr;
  return std::make_unique<DriveFields>(DriveFields::in_own_memory(briefing.size, *briefing.drive.model));
}

Briefing with_fields(Briefing briefing, DriveFields* own) {
  if (own != nullptr) briefing.drive.fields = own;
  return briefing;
}

}  // namespace

DrivingExplorer::DrivingExplorer(const Briefing& briefing)
    : fields_(fields_for(briefing)),
      briefing_(with_fields(briefing, fields_.get())),
      knowledge_(briefing.size, briefing.sight),
      place_{briefing.start, true},
      to_goal_(briefing.size, briefing.motion),
      clock_(std::make_unique<SearchClock>(briefing_)),
      goal_entered_(briefing.goals.contains(briefing.start.cell)) {
  assert(briefing.size.contains(briefing.start.cell) && !briefing.goals.empty());
}

DrivingExplorer::~DrivingExplorer() = default;

Action DrivingExplorer::decide(const Sighting& seen) {
  if (!knowledge_.learn(pose(), seen)) return Action::forfeit(ForfeitReason::contradiction);
  return decide();
}

Action DrivingExplorer::decide() {
  Action action = racing_ ? Action::forfeit(ForfeitReason::finished) : explore();
  if (must_go_home_before(action)) action = Action::reset();
  perform(action);
  return action;
}

Action DrivingExplorer::consider(const LogOddsMap& map, const SearchPlace& place, std::int64_t time) {
  knowledge_ = map.view();
  place_ = place;
  clock_->set(time);
  if (std::exchange(version_, map.version()) != map.version()) {
    // The map has changed: the goal that it had entered may be another cell, or may have no known route.
    to_goal_.fill(knowledge_.open(), briefing_.goals);
    goal_entered_ = goal_entered_ && to_goal_.reaches(briefing_.start.cell);
    renew();
  }
  if (!racing_) arrive();
  // Entering a goal counts on arrival, not when the step is decided.
  const bool entered = goal_entered_;
  const Action action = decide();
  goal_entered_ = entered;
  return action;
}

void DrivingExplorer::show(const Pose& pose, const Sighting& seen) { static_cast<void>(knowledge_.learn(pose, seen)); }

void DrivingExplorer::carried(std::int64_t time) {
  place_ = {briefing_.start, true};
  racing_ = false;
  clock_->set(time);
}

void DrivingExplorer::searches_at(double pace) { clock_->set_pace(pace); }

std::int64_t DrivingExplorer::time_left() const { return clock_->time_left(); }

bool DrivingExplorer::must_go_home_before(const Action& action) {
  return goal_entered_ && action.kind == Action::Kind::step && clock_->is_too_late_after(action, knowledge_, place_);
}

void DrivingExplorer::perform(const Action& action) {
  switch (action.kind) {
    case Action::Kind::step:
      clock_->count(knowledge_, place_, action);
      place_ = after_search(place_, action);
      assert(briefing_.size.contains(pose().cell));
      arrive();
      break;
    case Action::Kind::reset:
      assert(goal_entered_ && !racing_);
      place_ = {briefing_.start, true};
      racing_ = true;
      break;
    case Action::Kind::forfeit:
      break;
  }
}

void DrivingExplorer::arrive() { goal_entered_ = goal_entered_ || briefing_.goals.contains(pose().cell); }

}  // namespace labmouse
