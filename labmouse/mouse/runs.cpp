#include "labmouse/mouse/runs.hpp"

#include "labmouse/mouse/drive/drive_fields.hpp"

namespace labmouse {

StrideRuns::StrideRuns(const Briefing& briefing)
    : briefing_(briefing), field_(briefing.size, briefing.motion), optimistic_(briefing) {}

void StrideRuns::plan(const Knowledge& knowledge) {
  field_.fill(knowledge.open(), briefing_.goals);
  known_ = field_.at(briefing_.start.cell);
  optimistic_.plan(knowledge);
}

DriveRuns::DriveRuns(const Briefing& briefing)
    : start_(briefing.start), goals_(briefing.goals), routes_(briefing.drive.fields->routes()) {}

bool DriveRuns::plan(const WallSet& optimistic, const WallSet& open) {
  WallSet cut = walls_;
  cut -= optimistic;
  const bool anew = !planned_ || !cut.empty();
  if (anew) {
    routes_.fill_for(start_, optimistic, goals_);
    time_ = routes_.time_from(start_);
    walls_ = routes_.walls_from(start_);
    planned_ = true;
  }
  unknown_ = walls_;
  unknown_ -= open;
  return anew;
}

DriveTime DriveRuns::known_time(const Knowledge& knowledge) {
  routes_.fill_for(start_, knowledge.open(), goals_);
  return routes_.time_from(start_);
}

}  // namespace labmouse
