// dead-end: chance, but no step lost to walls.
//
// Limits: a corridor or a loop holds it as long as chance will. Where the share cannot be reached it wanders for ever.
// Choices: as for random-move.
#include <array>

#include "labmouse/strategies/roster.hpp"
#include "labmouse/strategies/wanderer.hpp"

namespace labmouse {
namespace {

constexpr std::string_view method =
    "Like random-move, but draws the turn again while a wall is in the way; in a dead end it turns right on the spot, "
    "and marks nothing there.";

constexpr std::string_view source =
    "Random move with dead end detection, in the fifth report, \"Plot and Navigate a Virtual Maze\", Algorithms "
    "and Techniques; its benchmark among explorers.";

class DeadEnd final : public Wanderer {
 public:
  using Wanderer::Wanderer;

 private:
  Action wander() override { return in_dead_end() ? Action::step(90, 0) : draw_a_free_cell(); }
};

constexpr std::array parameters = {wanderers_coverage, wanderers_search};

}  // namespace

constinit const RosterEntry dead_end_mouse = {
    "dead-end",
    "random turns to free cells; turns out of dead ends",
    method,
    source,
    parameters,
    [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<DeadEnd>(briefing, settings);
    },
    RosterEntry::always};

}  // namespace labmouse
