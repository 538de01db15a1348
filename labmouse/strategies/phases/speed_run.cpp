#include "labmouse/strategies/phases/speed_run.hpp"

#include "labmouse/mouse/route.hpp"

namespace labmouse {

Briefing briefing_for_speed(Briefing briefing, const Settings& settings) {
  if (settings.choice("speed") == "one-cell") briefing.motion.longest = 1;
  return briefing;
}

SpeedRun::SpeedRun(const Briefing& briefing, const Settings& settings)
    : start_(briefing.start.cell),
      goals_(briefing.goals),
      updating_(settings.choice("speed") == "strides-updating"),
      field_(briefing.size, briefing_for_speed(briefing, settings).motion) {}

int SpeedRun::length(const Knowledge& knowledge) {
  plan(knowledge);
  return field_.at(start_);
}

void SpeedRun::plan(const Knowledge& knowledge) {
  passages_ = knowledge.open();
  field_.fill(passages_, goals_);
}

Action SpeedRun::next(const Knowledge& knowledge, Pose pose) {
  if (updating_) plan(knowledge);
  return step_along(field_, passages_, pose);
}

}  // namespace labmouse
