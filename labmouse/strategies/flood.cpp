// flood, flood-return: flood fill, the classic strategy of contests.
//
// Limits: neither checks whether a shorter route may exist.
#include <algorithm>
#include <array>

#include "labmouse/mouse/driving_explorer.hpp"
#include "labmouse/mouse/explorer.hpp"
#include "labmouse/mouse/ways.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

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

class Flood final : public Explorer {
 public:
  Flood(const Briefing& briefing, const Settings& settings, bool returns)
      : Explorer(briefing), ways_(shortened(briefing, settings.whole("stride"))), returns_(returns) {}

 private:
  static Briefing shortened(Briefing briefing, int stride) {
    briefing.motion.longest = std::min(briefing.motion.longest, stride);
    return briefing;
  }

  Action explore() override {
    const Cell start = briefing().start.cell;
    if (goal_entered()) return !returns_ || pose().cell == start ? Action::reset() : step_towards(CellSet::of(start));
    // The start is a goal: it counts as entered only when a step ends there.
    return briefing().goals.contains(pose().cell) ? Action::step(0, 0) : step_towards(briefing().goals);
  }

  Action step_towards(const CellSet& cells) { return ways_.step_towards(cells, knowledge(), pose()); }

  StrideWays ways_;
  bool returns_;
};

/// The same in seconds.
class FloodDriver final : public DrivingExplorer {
 public:
  FloodDriver(const Briefing& briefing, bool returns)
      : DrivingExplorer(briefing), ways_(this->briefing()), returns_(returns) {}

 private:
  Action explore() override {
    const Cell start = briefing().start.cell;
    if (!goal_entered()) return step_towards(briefing().goals);
    return !returns_ || pose().cell == start ? Action::reset() : step_towards(CellSet::of(start));
  }

  Action step_towards(const CellSet& cells) {
    count_plan();
    return ways_.step_towards(cells, knowledge(), place());
  }

  SearchWays ways_;
  bool returns_;
};

constexpr std::array flood_parameters = {
    Parameter::whole("stride", "3", 1, Motion::max_longest,
                     "Longest move while exploring, in cells; the rules may set a lower limit."),
};

template <bool Returns>
std::unique_ptr<Strategy> make_flood(const Briefing& briefing, const Settings& settings) {
  return std::make_unique<Flood>(briefing, settings, Returns);
}

template <bool Returns>
std::unique_ptr<DrivingStrategy> drive_flood(const Briefing& briefing, const Settings&) {
  return std::make_unique<FloodDriver>(briefing, Returns);
}

}  // namespace

constinit const BuiltinMouse flood_mouse = {
    .name = "flood",
    .summary = "flood fill to the goal",
    .method = flood_method,
    .source = flood_source,
    .parameters = flood_parameters,
    .make = make_flood<false>,
    .drive = factory_in_seconds(drive_flood<false>),
};

constinit const BuiltinMouse flood_return_mouse = {
    .name = "flood-return",
    .summary = "flood fill to the goal and back to the start",
    .method = flood_method,
    .source = flood_source,
    .parameters = flood_parameters,
    .make = make_flood<true>,
    .drive = factory_in_seconds(drive_flood<true>),
};

}  // namespace labmouse
