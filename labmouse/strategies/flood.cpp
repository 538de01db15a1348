// flood, flood-return: the classic of the contests.
//
// Method: distances to the goal over all walls not known to be closed; go where they fall, look, fill again. `flood`
// resets as soon as it has entered the goal. `flood-return` floods back to the start in the same way first: the way back
// shows walls that the way there did not, for two or three steps of a run's score, and often a shorter route.
// Both then take the shortest known route.
// Limits: neither knows whether a shorter route is left.
// Source: the flood fill of the micromouse contests of the 1980s; the first report describes it for this world.
#include <algorithm>
#include <array>

#include "labmouse/mouse/explorer.hpp"
#include "labmouse/strategies/roster.hpp"

namespace labmouse {
namespace {

class Flood final : public Explorer {
 public:
  Flood(const Briefing& briefing, const Settings& settings, bool returns)
      : Explorer(briefing), optimistic_(briefing.size, shortened(briefing.motion, settings.whole("stride"))), returns_(returns) {
    start_.insert(briefing.start.cell);
  }

 private:
  static Motion shortened(Motion motion, int stride) {
    motion.longest = std::min(motion.longest, stride);
    return motion;
  }

  Action explore() override {
    if (!goal_entered()) {
      optimistic_.fill(knowledge().possible(), briefing().goals);
      // Standing on a goal without having entered it: the start is one. A step has to end there.
      if (optimistic_.at(pose().cell) == 0) return Action::step(0, 0);
      return optimistic_step(optimistic_);
    }
    if (!returns_ || pose().cell == briefing().start.cell) return Action::reset();
    optimistic_.fill(knowledge().possible(), start_);
    return optimistic_step(optimistic_);
  }

  DistanceField optimistic_;
  CellSet start_;
  bool returns_;
};

constexpr std::array parameters = {
    Parameter{"stride", ParameterType::whole, "3", 1, Motion::max_longest, "", "longest move while exploring, in cells; the rules' own limit holds too"},
};

}  // namespace

const RosterEntry flood_mouse = {"flood", "flood fill to the goal", parameters,
                                 [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
                                   return std::make_unique<Flood>(briefing, settings, false);
                                 }};

const RosterEntry flood_return_mouse = {
    "flood-return", "flood fill to the goal and back to the start", parameters,
    [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<Flood>(briefing, settings, true);
    }};

}  // namespace labmouse
