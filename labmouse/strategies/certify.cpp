// certify: explores until its route is proven shortest, and no further.
//
// Method: flood fill to the goal, because the reset needs it entered and the way there is worth seeing. From then on the
// shortest optimistic route, which takes unknown walls for open, is compared with the shortest known one. While it is
// shorter, some wall on it is unknown: the mouse goes to the nearest cell from which it can see such a wall (any on any
// shortest optimistic route), looks, and plans again. When both lengths agree, nothing unseen can make the route
// shorter: it is proven, and the mouse resets. Where the budget ends before the proof, it resets while it still can.
// Limits: buys the proof at any price; a point of score is 30 steps of exploration, and the proof often costs more.
// Source: contest mice explore so before they dare the fast run; as a walk that plans anew on optimistic costs it is
// kin to D* Lite (Koenig and Likhachev 2002).
#include "labmouse/mouse/explorer.hpp"
#include "labmouse/mouse/optimistic_routes.hpp"
#include "labmouse/strategies/roster.hpp"

namespace labmouse {
namespace {

class Certify final : public Explorer {
 public:
  explicit Certify(const Briefing& briefing)
      : Explorer(briefing),
        optimistic_(briefing),
        plan_(briefing.size, briefing.motion),
        travel_(briefing.size, briefing.motion) {}

 private:
  Action explore() override {
    if (!goal_entered()) return enter_goal();
    plan_.fill(knowledge().open(), briefing().goals);
    const int known = plan_.at(briefing().start.cell);
    // The last moment at which the reset and the known route still fit into the budget.
    const bool last_call = steps_left() <= known + 1;
    return last_call || proven(known) ? Action::reset() : go_and_look();
  }

  Action enter_goal() {
    plan_.fill(knowledge().possible(), briefing().goals);
    // The start may be a goal; a step has to end there.
    return plan_.at(pose().cell) == 0 ? Action::step(0, 0) : optimistic_step(plan_);
  }

  /// Whether no route that could exist is shorter than the known one.
  bool proven(int known) {
    optimistic_.plan(knowledge());
    return optimistic_.length() == known && known < unreachable;
  }

  Action go_and_look() {
    if (optimistic_.length() == unreachable) return Action::forfeit(ForfeitReason::no_way);
    const CellSet viewpoints = viewpoints_of(optimistic_.unknown_walls());
    // Standing where the wall could be seen and not seeing it: it is behind.
    if (viewpoints.contains(pose().cell)) return Action::step(90, 0);
    travel_.fill(knowledge().open(), viewpoints);
    return step_along(travel_, knowledge().open(), pose());
  }

  /// The cells that look along a corridor of open walls at one of the walls.
  CellSet viewpoints_of(const WallSet& walls) const {
    CellSet cells;
    walls.for_each([&](Wall wall) {
      for (const Heading direction : {wall.side, opposite(wall.side)}) {
        Cell cell = direction == wall.side ? wall.cell : neighbour(wall.cell, wall.side);
        cells.insert(cell);
        for (int away = 1; away < briefing().sight && knowledge().open().contains(wall_at(cell, opposite(direction))); ++away) {
          cell = neighbour(cell, opposite(direction));
          cells.insert(cell);
        }
      }
    });
    return cells;
  }

  OptimisticRoutes optimistic_;
  DistanceField plan_;
  DistanceField travel_;
};

}  // namespace

const RosterEntry certify_mouse = {"certify", "explores until its route is proven shortest, or the budget only just allows it", {},
                                   [](const Briefing& briefing, const Settings&) -> std::unique_ptr<Strategy> {
                                     return std::make_unique<Certify>(briefing);
                                   }};

}  // namespace labmouse
