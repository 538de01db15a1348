// visit-counter: to where it was least often.
//
// Limits: no care for where the goal is; sees far and learns only near. The search counts cells, not steps, so the way
// may take more steps than another does. Where the share cannot be reached it wanders for ever.
// Choices: the text ends the exploration with half of the cells, the code in it with five sixths; the default is the
// code's, which on the test mazes comes nearer to the reported numbers of steps. A cell counts where a step ends;
// passages that a stride went through are known, as the way that it came. Of cells only one step away, the one behind
// is not asked for, because no step turns round; each step counts as a visit, one on the spot too. `ties` orders both
// the neighbours visited equally often and the search; of the orders with which A* finds as many cells as reported on
// test mazes 1 and 3, the default is the first by the compass (east, south, north, west).
#include <array>

#include "labmouse/mouse/visits.hpp"
#include "labmouse/strategies/roster.hpp"
#include "labmouse/strategies/wanderer.hpp"

namespace labmouse {
namespace {

constexpr std::string_view method =
    "Counts how often it has stood in each cell. Most steps go one cell to the left, ahead or to the right, whichever "
    "was visited least; with a fixed probability the step is random instead, so that no loop traps it for ever; in a "
    "dead end it turns right on the spot. Once it has entered a goal and stood in a share of all cells, it resets, "
    "plans its path by a textbook search over the walls around those cells, and runs it in the longest strides.";

constexpr std::string_view source =
    "The final explorer of the fifth report, \"Plot and Navigate a Virtual Maze\", Algorithms and Techniques, "
    "Refinement.";

class VisitCounter final : public Wanderer {
 public:
  VisitCounter(const Briefing& briefing, const Settings& settings)
      : Wanderer(briefing, settings.real("coverage"), search_method(settings.choice("search")),
                 TieOrder(settings.choice("ties"))),
        visits_(briefing.size),
        ties_(settings.choice("ties")),
        random_share_(settings.real("random_share")) {}

 private:
  Action wander() override {
    visits_.add(pose().cell);
    constexpr int sides = 1'000'000;
    if (dice().below(sides) < random_share_ * sides) return random_step();
    return to_the_least_visited();
  }

  /// One cell to the neighbour that was visited least, of those to the left, ahead and to the right.
  Action to_the_least_visited() {
    int fewest = 0;
    Action best = Action::step(90, 0);  // a dead end: the way out is behind
    for (const Heading direction : ties_.from(pose().heading)) {
      if (direction == opposite(pose().heading)) continue;
      const Action step = move_in(pose().heading, direction, 1);
      if (seen().towards(step.rotation / 90) == 0) continue;
      const int visits = visits_.of(neighbour(pose().cell, direction));
      if (best.movement > 0 && visits >= fewest) continue;
      fewest = visits;
      best = step;
    }
    return best;
  }

  Visits visits_;
  TieOrder ties_;
  double random_share_;
};

constexpr std::array parameters = {
    Parameter{"random_share", ParameterType::real, "0.2", 0, 1, "", "probability of a random step"},
    Parameter{"coverage", ParameterType::real, "0.8333", 0, 1, "", "share of all cells to stand in before the reset"},
    Parameter{"search", ParameterType::choice, "a-star", 0, 0, "breadth-first/a-star/dijkstra",
              "how to plan the speed run"},
    Parameter{"ties", ParameterType::choice, "esnw", 0, 0, TieOrder::all,
              "order of the directions, among cells visited equally often and in the search"},
};

}  // namespace

constinit const RosterEntry visit_counter_mouse = {
    "visit-counter",
    "goes to the least visited neighbour, sometimes at random",
    method,
    source,
    parameters,
    [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<VisitCounter>(briefing, settings);
    },
    RosterEntry::always};

}  // namespace labmouse
