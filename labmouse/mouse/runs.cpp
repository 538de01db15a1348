#include "labmouse/mouse/runs.hpp"

#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

StrideRuns::StrideRuns(const Briefing& briefing)
    : briefing_(briefing), field_(briefing.size, briefing.motion), hoped_(briefing) {}

bool StrideRuns::plan(const Knowledge& knowledge) {
  field_.fill(knowledge.open(), briefing_.goals);
  known_ = field_.at(briefing_.start.cell);
  hoped_.plan(knowledge);
  return true;
}

DriveRuns::DriveRuns(const Briefing& briefing)
    : tables_(briefing.drive.model->tables),
      start_(briefing.start),
      goals_(briefing.goals),
      routes_(briefing.size, tables_) {
  // A straight and a turn for each cell at most, whichever way it is passed.
  route_.segments.reserve(static_cast<std::size_t>(8 * briefing.size.area()));
}

bool DriveRuns::plan(const WallSet& hoped, const WallSet& open) {
  WallSet cut = walls_;
  cut -= hoped;
  const bool anew = !planned_ || !cut.empty();
  if (anew) {
    routes_.fill_for(start_, hoped, goals_);
    routes_.route_from(start_, route_);
    walls_ = walls_needed_by(route_, tables_);
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
