// dead-end: chance, but no time lost in dead ends.
//
// Limits: a corridor or a loop holds it as long as chance will. Where the share cannot be reached it wanders for ever.
// Choices: as for random-move.
#include <array>

#include "labmouse/strategies/roster.hpp"
#include "labmouse/strategies/wanderer.hpp"

namespace labmouse {
namespace {

constexpr std::string_view method =
    "Like random-move, but with walls to the left, ahead and to the right, it turns right on the spot; after that only "
    "the way out is open.";

constexpr std::string_view source =
    "Random move with dead end detection, in the fifth report, \"Plot and Navigate a Virtual Maze\", Algorithms "
    "and Techniques; its benchmark among explorers.";

class DeadEnd final : public Wanderer {
 public:
  DeadEnd(const Briefing& briefing, const Settings& settings)
      : Wanderer(briefing, settings.real("coverage"), SearchMethod::breadth_first, TieOrder("esnw")) {}

 private:
  Action wander() override { return seen() == Sighting{0, 0, 0} ? Action::step(90, 0) : random_step(); }
};

constexpr std::array parameters = {half_coverage};

}  // namespace

constinit const RosterEntry dead_end_mouse = {
    "dead-end",
    "random turns and movements, but turns out of dead ends",
    method,
    source,
    parameters,
    [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<DeadEnd>(briefing, settings);
    },
    RosterEntry::always};

}  // namespace labmouse
