#include "labmouse/mouse/runs.hpp"

#include <algorithm>

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

bool DriveRuns::plan(const WallSet& optimistic, const Knowledge& knowledge) {
  WallSet cut = walls_;
  cut -= optimistic;
  const bool anew = !planned_ || !cut.empty();
  if (anew) {
    // Fewer passages are possible at each plan, so that those of now give bounds for the next ones.
    constexpr int plans_for_an_aim = 8;
    constexpr double longer = 1.1;
    if (planned_ && time_ < no_time && aimed_plans_-- == 0) {
      routes_.aim(start_, knowledge.possible(), static_cast<DriveTime>(std::min<double>(no_time, longer * time_)));
      aimed_plans_ = plans_for_an_aim;
    }
    // Routes only become slower, mostly a little: one not much slower than the last is found faster.
    const DriveTime limit = planned_ && time_ < no_time ? time_ + time_ / 8 : no_time;
    routes_.fill_for(start_, optimistic, goals_, limit);
    time_ = routes_.time_from(start_);
    if (time_ > limit) {
      routes_.fill_for(start_, optimistic, goals_);
      time_ = routes_.time_from(start_);
    }
    walls_ = routes_.walls_from(start_);
    planned_ = true;
  }
  unknown_ = walls_;
  unknown_ -= knowledge.open();
  return anew;
}

DriveTime DriveRuns::known_time(const Knowledge& knowledge, DriveTime limit) {
  routes_.fill_for(start_, knowledge.open(), goals_, limit);
  const DriveTime time = routes_.time_from(start_);
  return time <= limit ? time : no_time;
}

}  // namespace labmouse
