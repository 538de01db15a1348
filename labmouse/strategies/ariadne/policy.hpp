// Parameters of ariadne in the world of steps, as integers.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "labmouse/mouse/reasons.hpp"
#include "labmouse/strategies/ariadne/drive_policy.hpp"
#include "labmouse/strategies/ariadne/outlook.hpp"
#include "labmouse/strategies/parameter.hpp"

namespace labmouse::ariadne {

/// Costs are in thirtieths of a step of the speed run, so that a step of the search run costs 1 in a score.
inline constexpr int step_price = costs_a_step;
/// Weights of costs, and scores, are in 1/256.
inline constexpr int one = 256;

/// In mazes of more cells the next wall tells too little about a run: the mouse floods, and uses the prices only to
/// decide when to stop.
inline constexpr int largest_to_weigh = 900;

/// The weights of one phase of the search run.
struct Phase {
  PriceTable prices{};  ///< of unseen walls
  int way_here = 0;     ///< weight of the cost from the start to a wall, in the cost of a run through it
  int travel = 0;       ///< weight of a step to where a wall is seen, in the comparison of walls
  int insight = 0;      ///< bonus for each unseen wall that is seen from there
};

struct Policy {
  Phase before;  ///< before the goal has been entered
  Phase after;
  /// Prices for `before` when nothing is left to look at: no wall counts as closed.
  PriceTable last_resort{};
  int goal_bonus = 0;             ///< bonus for entering the goal, once a way is known
  int stop_travel = 0;            ///< weight of a step to where a wall is seen, for the decision to stop
  int stop_margin = 0;            ///< how much more than its possible gain a look may cost
  bool loop_free = false;         ///< stop at the goal, always
  bool may_be_loop_free = false;  ///< stop at the goal if the walls seen indicate a maze without loops

  explicit Policy(const Settings& settings);

 private:
  void take_numbers(const Settings& settings);
  void take_model(std::string_view model);
};

/// Parameters of `ariadne`: those of Policy, then those of DrivePolicy; and of `ariadne-deep`, which does not race in
/// seconds: those of Policy with its own defaults.
extern const std::array<Parameter, 17 + drive_parameters.size()> fast_parameters;
extern const std::array<Parameter, 17> deep_parameters;

}  // namespace labmouse::ariadne
