// visit-counter: goes to the least visited neighbour.
//
// Limits: ignores where the goal is, and maps only passages that it walks. Only random choices mark a cell, so search
// runs are longer than necessary. Its map can lack a passage (WalkedPassages::slip). If the share of cells to mark
// (`coverage`) cannot be reached, it never resets.
// Choices: the share is that of the report's listing, 5/6; the program had 1/2, 3/4 and 4/5 at other times.
#include <algorithm>
#include <array>
#include <limits>

#include "labmouse/mouse/visits.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "labmouse/strategies/wanderer.hpp"

namespace labmouse {
namespace {

class VisitCounter final : public Wanderer {
 public:
  VisitCounter(const Briefing& briefing, const Settings& settings)
      : Wanderer(briefing, settings), visits_(briefing.size), random_share_(settings.real("random_share")) {}

 private:
  Action wander() override {
    visits_.add(pose().cell);
    if (in_dead_end()) return Action::step(90, 0);
    sides_ = {Side{-1, visits_at(-1)}, Side{0, visits_at(0)}, Side{1, visits_at(1)}};
    for (;;) {
      if (is_random()) {
        if (const int quarters = draw(); is_free(quarters)) return Action::step(90 * quarters, 1);
        continue;
      }
      Side& choice = least_visited();
      if (is_free(choice.quarters)) return Action::step(90 * choice.quarters, 1);
      if (choice.struck_out) return draw_a_free_cell();  // it would be chosen again and again, so draw instead
      choice.struck_out = true;
    }
  }

  bool is_random() {
    constexpr int sides = 1'000'000;
    return rng().below(sides) < random_share_ * sides;
  }

  struct Side {
    int quarters = 0;
    int visits = 0;
    bool struck_out = false;
  };
  static constexpr int beyond = std::numeric_limits<int>::max();  ///< visits outside of the maze

  int visits_at(int quarters) const {
    const Cell cell = neighbour(pose().cell, turned(pose().heading, quarters));
    return briefing().size.contains(cell) ? visits_.of(cell) : beyond;
  }

  /// The last side that has the lowest count of those not struck out. As in the original program, sides are found by
  /// their count, so a struck-out side can hide another one with the same count.
  Side& least_visited() {
    int least = beyond;
    for (const Side& side : sides_)
      if (!side.struck_out) least = std::min(least, side.visits);
    return *std::find_if(sides_.rbegin(), sides_.rend(), [least](const Side& side) { return side.visits == least; });
  }

  Visits visits_;
  std::array<Side, 3> sides_{};
  double random_share_;
};

constexpr std::array visit_counter_parameters = {
    Parameter::real("random_share", "0.2", 0, 1, "Probability of a random choice."),
    wanderers_coverage,
    wanderers_search,
};

}  // namespace

constinit const BuiltinMouse visit_counter_mouse = {
    .name = "visit-counter",
    .summary = "goes to the least visited neighbour, sometimes at random",
    .method =
        "Counts how often it has stood in each cell, and goes to the neighbour to the left, ahead or to the right "
        "that was visited least, of equal ones to the last of these; in a dead end it turns right on the spot. Counts "
        "are compared whatever walls there are: where the choice turns out to be behind one, it chooses again. With a "
        "fixed probability a choice is random instead, so that no loop traps it for ever, and only such a choice "
        "marks the cell. Once it has marked a goal and a share of all cells, it resets, plans its path by a textbook "
        "search over the passages that it walked, and runs it in the longest strides.",
    .source =
        "The final explorer of the fifth report, \"Plot and Navigate a Virtual Maze\", Algorithms and Techniques, "
        "Refinement.",
    .parameters = visit_counter_parameters,
    .make = [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<VisitCounter>(briefing, settings);
    },
    .uses_chance = BuiltinMouse::always,
};

}  // namespace labmouse
