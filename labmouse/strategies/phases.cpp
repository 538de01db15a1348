// phases: three exchangeable phases, each with methods to choose from.
//
// Limits: random searches and the wall follower may not find the goal. No method regards the budget before a goal is
// entered.
// Choices: as the report's program does it; `optimistic`, `coverage`, `worthwhile` and `unexplored-cell` are not in it.
//   A side is explored once it is seen; the border is explored from the beginning.
//   goal-oriented considers the cells that a search from the start reaches, cell by cell in the order of `ties`, and
//   that have an unexplored side. It takes the lowest sum of strides from here and explored sides. The report's text
//   adds the distance to the goal, which in its program is the same for all cells. Ties go to the first in the order
//   of a Python 2.7 set (`order`), on the way that a search from here finds first.
//   If all weights are 0, all ways are equally likely.
//   all-goals takes one cell a step.
//   coverage also ends when every reachable cell is explored.
//   worthwhile explores the unknown walls on the shortest optimistic routes, as long as these are shorter than the
//   shortest known one in the moves of the speed run; so it ends with the proof that none is shorter.
//   Continuing ends in time for the reset and the known route.
#include <array>

#include "labmouse/mouse/explorer.hpp"
#include "labmouse/mouse/hashed_cells.hpp"
#include "labmouse/mouse/tie_order.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "labmouse/strategies/phases/continuing.hpp"
#include "labmouse/strategies/phases/searching.hpp"
#include "labmouse/strategies/phases/speed_run.hpp"

namespace labmouse {
namespace {

class Phases final : public Explorer {
 public:
  Phases(const Briefing& briefing, const Settings& settings)
      : Explorer(briefing),
        searching_(make_searching(briefing, settings)),
        continuing_(make_continuing(briefing, settings, *searching_)),
        speed_run_(briefing, settings) {}

 private:
  Action explore() override {
    if (!goal_entered()) return search();
    if (!last_call())
      if (const auto action = continuing_->next(knowledge(), pose(), visited())) return *action;
    speed_run_.plan(knowledge());
    return Action::reset();
  }

  Action race() override { return speed_run_.next(knowledge(), pose()); }

  Action search() {
    // The start may be a goal; a step has to end there.
    if (briefing().goals.contains(pose().cell)) return Action::step(0, 0);
    return searching_->next(knowledge(), pose()).value_or(Action::forfeit(ForfeitReason::no_route));
  }

  /// Whether this is the last moment at which the reset and the known route still fit into the budget.
  bool last_call() { return steps_left() <= speed_run_.length(knowledge()) + 1; }

  std::unique_ptr<Searching> searching_;
  std::unique_ptr<Continuing> continuing_;
  SpeedRun speed_run_;
};

constexpr std::array phases_parameters = {
    Parameter::choice("searching", "goal-oriented",
                      "random/weighted/unexplored-cell/unexplored-space/wall-follower/goal-oriented",
                      "Method of finding the goal."),
    Parameter::list(
        "weights", "2/5/2", 0, 100,
        "Weights of going left, ahead and right, in proportion to their probabilities (searching=weighted only)."),
    Parameter::choice("heuristic", "edges", "none/edges/manhattan/manhattan-edges/optimistic",
                      "Added to the steps to a cell: nothing (none), its explored sides (edges), its Manhattan "
                      "distance to the goal (manhattan), both, or the steps of its shortest route over walls not known "
                      "to be closed (optimistic); for searching=goal-oriented."),
    Parameter::choice("continuing", "none", "none/all-goals/coverage/worthwhile",
                      "What is explored between the goal and the reset."),
    Parameter::real("coverage", "0.9", 0, 1,
                    "Share of the cells to explore before the reset (continuing=coverage only)."),
    Parameter::choice("speed", "strides", "one-cell/strides/strides-updating",
                      "Moves of the speed run: one cell a step (one-cell), the longest moves (strides), or those "
                      "planned again at every step (strides-updating)."),
    Parameter::choice("ties", "swne", TieOrder::all,
                      "Order of the directions in which searches try equally good neighbours."),
    Parameter::choice(
        "order", "python-2.7", all_cell_orders,
        "Order of the hash table of that Python version, or row by row (rows), in which equally good cells are tried."),
};

}  // namespace

constinit const BuiltinMouse phases_mouse = {
    .name = "phases",
    .summary = "three interchangeable phases: find the goal, continue, run",
    .method =
        "Three phases: searching until a goal is entered, continuing until enough is known, and the speed run. "
        "Searching: random and weighted go one cell to the left, ahead or to the right at random, and turn in place "
        "in a dead end; unexplored-cell and unexplored-space do the same, weighted by what is unexplored in the next "
        "cell, or by everything that can be reached through it; wall-follower keeps its left hand on the wall; "
        "goal-oriented goes to the reachable unexplored cell with the lowest steps + heuristic, chosen again at every "
        "step. Continuing: none; all-goals enters every goal cell; coverage continues the search until a share of the "
        "cells is explored; worthwhile makes the same choice among cells that can still shorten the speed run, until "
        "none can. The speed run takes one cell a step, or strides planned at the reset, or strides planned again at "
        "every step.",
    .source =
        "Frank Ding, \"Machine Learning Engineer Nanodegree, Capstone Project\", 2018 (the fourth report), sections "
        "II and III; `coverage` is described there but was not written, `worthwhile` and `optimistic` are its wishes.",
    .parameters = phases_parameters,
    .make = [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<Phases>(briefing, settings);
    },
    .uses_chance = searches_by_chance,
};

}  // namespace labmouse
