// certify: explores until its route is proven shortest, and no further.
//
// Limits: proves the route at any cost. 30 steps of the search run cost as much as one of the speed run, and the proof
// often costs more than it saves.
#include "labmouse/mouse/driving_explorer.hpp"
#include "labmouse/mouse/explorer.hpp"
#include "labmouse/mouse/runs.hpp"
#include "labmouse/mouse/ways.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {
namespace {

class Certify final : public Explorer {
 public:
  explicit Certify(const Briefing& briefing) : Explorer(briefing), runs_(briefing), ways_(briefing) {}

 private:
  Action explore() override {
    if (!goal_entered()) return enter_goal();
    runs_.plan(knowledge());
    return runs_.last_call(steps_left()) || runs_.proven() ? Action::reset() : go_and_look();
  }

  Action enter_goal() {
    // The start may be a goal: it counts as entered only when a step ends there.
    if (briefing().goals.contains(pose().cell)) return Action::step(0, 0);
    return ways_.step_towards(briefing().goals, knowledge(), pose());
  }

  Action go_and_look() {
    if (runs_.hopeless()) return Action::forfeit(ForfeitReason::no_route);
    const CellSet viewpoints = viewpoints_of(runs_.unknown_walls(), knowledge(), briefing().sight);
    // At a viewpoint and still unseen: the wall is behind the mouse.
    if (viewpoints.contains(pose().cell)) return Action::step(90, 0);
    return ways_.step_to_look(viewpoints, knowledge(), pose());
  }

  StrideRuns runs_;
  StrideWays ways_;
};

/// The same in seconds.
class CertifyDriver final : public DrivingExplorer {
 public:
  explicit CertifyDriver(const Briefing& briefing)
      : DrivingExplorer(briefing), runs_(this->briefing()), ways_(this->briefing()) {}

 private:
  Action explore() override {
    if (!goal_entered()) return enter_goal();
    if (runs_.plan(knowledge())) count_plan();
    return runs_.proven() ? Action::reset() : go_and_look();
  }

  void renew() override { runs_.forget(); }

  Action enter_goal() {
    count_plan();
    return ways_.step_towards(briefing().goals, knowledge(), place());
  }

  Action go_and_look() {
    const CellSet viewpoints = viewpoints_of(runs_.unknown_walls(), knowledge(), briefing().sight);
    // At a viewpoint and still unseen: the wall is behind the mouse.
    if (viewpoints.contains(pose().cell)) return Action::step(90, 0);
    return ways_.step_towards(viewpoints, knowledge(), place());
  }

  DriveRuns runs_;
  SearchWays ways_;
};

}  // namespace

constinit const BuiltinMouse certify_mouse = {
    .name = "certify",
    .summary = "explores until its route is proven shortest, or the budget is about to run out",
    .method =
        "Flood fill to the goal, because it must be entered before the reset and the way there is worth seeing. From "
        "then on, the shortest optimistic route, which assumes that unknown walls are open, is compared with the "
        "shortest known one. While it is shorter, some wall on it is unknown: the mouse goes to the nearest cell from "
        "which it can see such a wall (any on any shortest optimistic route), looks, and plans again. When both "
        "lengths agree, nothing unseen can make the route shorter: it is proven, and the mouse resets. If the budget "
        "would run out before the proof, it resets while it still can. In seconds it does the same with search times: "
        "it looks at the nearest unknown wall of one fastest optimistic route, until that route is fully known.",
    .source =
        "Contest mice explore like this before the speed run; as a walk that replans on optimistic costs, "
        "it is related to D* Lite (Koenig and Likhachev 2002).",
    .make = [](const Briefing& briefing, const Settings&) -> std::unique_ptr<Strategy> {
      return std::make_unique<Certify>(briefing);
    },
    .drive = factory_in_seconds([](const Briefing& briefing, const Settings&) -> std::unique_ptr<DrivingStrategy> {
      return std::make_unique<CertifyDriver>(briefing);
    }),
};

}  // namespace labmouse
