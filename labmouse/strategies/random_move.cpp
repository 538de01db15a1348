// random-move: chance alone.
//
// Limits: leaves a dead end only by two turns that happen to point the same way; seldom reaches the goal of a large
// maze within the budget. Where the share cannot be reached it wanders for ever.
// Choices: half of the cells have to be visited, as the text says of all its explorers; with the five sixths of its
// code this mouse hardly ever ends in time. The rest as for visit-counter.
#include <array>

#include "labmouse/strategies/roster.hpp"
#include "labmouse/strategies/wanderer.hpp"

namespace labmouse {
namespace {

constexpr std::string_view method =
    "A random turn of -90, 0 or 90 degrees and a random movement from 0 to the largest number of cells, drawn again "
    "while a wall is in the way; it ignores whatever else it sees. Once it has entered a goal and stood in a share of "
    "all cells, it resets and runs the path that a breadth-first search finds among the walls around the cells in "
    "which it stood.";

constexpr std::string_view source =
    "Random move, in the fifth report, \"Plot and Navigate a Virtual Maze\", Algorithms and Techniques.";

class RandomMove final : public Wanderer {
 public:
  RandomMove(const Briefing& briefing, const Settings& settings)
      : Wanderer(briefing, settings.real("coverage"), SearchMethod::breadth_first, TieOrder("esnw")) {}

 private:
  Action wander() override { return random_step(); }
};

constexpr std::array parameters = {half_coverage};

}  // namespace

constinit const RosterEntry random_move_mouse = {
    "random-move",
    "random turns and movements, whatever it sees",
    method,
    source,
    parameters,
    [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<RandomMove>(briefing, settings);
    },
    RosterEntry::always};

}  // namespace labmouse
