#include "labmouse/strategies/ariadne/driver.hpp"

#include <algorithm>

#include "labmouse/mouse/drive/drive_fields.hpp"
#include "labmouse/mouse/explorer.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "labmouse/mouse/runs.hpp"
#include "labmouse/mouse/ways.hpp"
#include "labmouse/strategies/ariadne/outlook.hpp"

namespace labmouse::ariadne {
namespace {

/// A wall's price is its reluctance, -ln P(open) in 1/32.
constexpr PriceTable reluctances = [] {
  PriceTable table{};
  for (unsigned reluctance = 0; reluctance < table.size(); ++reluctance)
    table[reluctance] = static_cast<std::uint8_t>(std::min<int>(static_cast<int>(reluctance), WallPrices::highest));
  return table;
}();
// Tried on 260 contest mazes under a thirtieth with published times of a robot, November 2026: mean of run and a
// thirtieth of the search 11.51 s, where flood-return has 11.62 and certify 12.00. Prices from half to twice of this do
// as well; a hope that no wall is left out of costs 0.04 s.
/// So many units of price are worth a cell of a search.
constexpr int prices_a_cell = 40;
/// Walls that are rather closed than open (P(open) < 0.46) are no hope for a route.
constexpr int no_hope = 25;

/// exp(-n / 32), the same on every platform.
double probability(int reluctance) {
  double probability = 1.0;
  for (; reluctance > 0; --reluctance) probability *= 0.96923323447634413;
  return probability;
}

class Driver final : public Explorer {
 public:
  Driver(const Briefing& briefing, const WallPrior* prior)
      : Explorer(briefing),
        search_(briefing.drive.model->search),
        outlook_(briefing, prior),
        hoped_(this->briefing()),
        known_(this->briefing()),
        ways_(this->briefing().drive.fields->ways()) {
    outlook_.price(reluctances);
  }

 private:
  Action explore() override {
    outlook_.learn(pose(), seen());
    if (!goal_entered()) {
      count_plan();
      return step_towards(briefing().goals);
    }
    const DriveTime known = weighs() ? known_.known_time(knowledge()) : no_time;
    const bool needs_proof = known == no_time;
    if (hoped_.plan(hope(needs_proof), knowledge().open())) count_plan();
    if (hoped_.proven()) return stop();
    const CellSet viewpoints = viewpoints_of(hoped_.unknown_walls(), knowledge(), briefing().sight);
    // Standing where the wall could be seen and not seeing it: it is behind.
    if (viewpoints.contains(pose().cell)) return Action::step(90, 0);
    const Action step = step_towards(viewpoints);
    return needs_proof || pays(known) ? step : stop();
  }

  /// Whether the time in the maze counts, so that it has something to weigh.
  bool weighs() const { return briefing().drive.maze_time_divisor > 0; }

  /// Passages that the mouse hopes for: all that may be open, or those that are likely enough.
  WallSet hope(bool all) const {
    WallSet walls = knowledge().possible();
    if (all) return walls;
    knowledge().unknown().for_each([&](Wall wall) {
      if (outlook_.prices().of(wall) >= no_hope) walls.erase(wall);
    });
    return walls;
  }

  /// Where there is something to prove, that is done: home on known ways. Else the way home may show something yet.
  Action stop() {
    if (!weighs() || pose().cell == briefing().start.cell) return Action::reset();
    return step_towards(CellSet::of(briefing().start.cell));
  }

  Action step_towards(const CellSet& cells) {
    SearchTolls tolls{search_};
    tolls.unit = search_.cell / prices_a_cell;
    ways_.fill(outlook_.prices(), tolls, knowledge().known_cells(), cells);
    return hopeful_step(ways_, knowledge(), place());
  }

  /// Whether what the hoped-for route could save, by the chance that it exists, is more than the look at its next wall
  /// costs.
  bool pays(DriveTime known) {
    int reluctance = 0;
    hoped_.unknown_walls().for_each([&](Wall wall) { reluctance += outlook_.prices().of(wall); });
    const double gain = probability(reluctance) * (known - hoped_.hoped_time());
    return gain * briefing().drive.maze_time_divisor > detour();
  }

  /// What the way to the look and from there home takes longer than the one home from here. The way to the look must
  /// stand in the field; afterwards the way home does.
  DriveTime detour() {
    DriveTime travel = 0;
    const CellSet known = knowledge().known_cells();
    SearchPlace at = place();
    for (Action step = ways_.step(at); step.movement > 0; step = ways_.step(at)) {
      travel += search_time(search_, at, step, known);
      at = after_search(at, step);
    }
    ways_.fill(knowledge().possible(), known, CellSet::of(briefing().start.cell));
    return travel + ways_.from(at) - ways_.from(place());
  }

  SearchDrive search_;
  Outlook outlook_;
  DriveRuns hoped_;
  DriveRuns known_;
  SearchField& ways_;
};

}  // namespace

std::unique_ptr<Strategy> make_driver(const Briefing& briefing, const WallPrior* prior) {
  return std::make_unique<Driver>(briefing, prior);
}

}  // namespace labmouse::ariadne
