// flood, flood-return: the classic of the contests.
//
// Limits: neither knows whether a shorter route is left.
#include <algorithm>
#include <array>

#include "labmouse/mouse/explorer.hpp"
#include "labmouse/mouse/ways.hpp"
#include "labmouse/strategies/roster.hpp"

namespace labmouse {
namespace {

constexpr std::string_view flood_method =
    "Computes distances to the goal through all walls not known to be closed, moves to lower distances, looks, and "
    "fills again. `flood` resets as soon as it has entered the goal. `flood-return` first floods back to the start in "
    "the same way: for two or three steps' worth of score, the way back shows walls that the way there did not, and "
    "often a shorter route. Both then take the shortest known route. In seconds they do the same with search times and "
    "the fastest known route.";

constexpr std::string_view flood_source =
    "The flood fill of the micromouse contests of the 1980s; the first report describes it for this world.";

template <class Ways>
class Flood final : public Explorer {
 public:
  Flood(const Briefing& briefing, const Settings& settings, bool returns)
      : Explorer(briefing), optimistic_(shortened(this->briefing(), settings.whole("stride"))), returns_(returns) {
    start_.insert(briefing.start.cell);
  }

 private:
  static Briefing shortened(Briefing briefing, int stride) {
    briefing.motion.longest = std::min(briefing.motion.longest, stride);
    return briefing;
  }

  Action explore() override {
    if (!goal_entered()) {
      // Standing on a goal without having entered it: the start is one. A step has to end there.
      if (briefing().goals.contains(pose().cell)) return Action::step(0, 0);
      return step_towards(briefing().goals);
    }
    if (!returns_ || pose().cell == briefing().start.cell) return Action::reset();
    return step_towards(start_);
  }

  Action step_towards(const CellSet& cells) {
    count_plan();
    return optimistic_.step_towards(cells, knowledge(), place());
  }

  Ways optimistic_;
  CellSet start_;
  bool returns_;
};

constexpr std::array flood_parameters = {
    Parameter::whole("stride", "3", 1, Motion::max_longest,
                     "longest move while exploring, in cells, within the limit of the rules"),
};

template <bool Returns>
std::unique_ptr<Strategy> make_flood(const Briefing& briefing, const Settings& settings) {
  if (briefing.in_seconds()) return std::make_unique<Flood<SearchWays>>(briefing, settings, Returns);
  return std::make_unique<Flood<StrideWays>>(briefing, settings, Returns);
}

}  // namespace

constinit const RosterEntry flood_mouse = {
    .name = "flood",
    .summary = "flood fill to the goal",
    .method = flood_method,
    .source = flood_source,
    .parameters = flood_parameters,
    .make = make_flood<false>,
    .drives = true,
};

constinit const RosterEntry flood_return_mouse = {
    .name = "flood-return",
    .summary = "flood fill to the goal and back to the start",
    .method = flood_method,
    .source = flood_source,
    .parameters = flood_parameters,
    .make = make_flood<true>,
    .drives = true,
};

}  // namespace labmouse
