// frontier: to the nearest cell that it has not visited.
//
// Limits: does not care where the goal is; follows long dead ends to their end, and takes wide rooms cell by cell.
// Choices: what it shares with the report's other seeker, see Seeker. The report does not say in which order equally
// near cells are listed. In the order of a map of Python 3.5 its scores in all three mazes and in the empty one come
// out, whatever `ties` is; with the maps of 2.7 and 3.6 they do not. Were corridors joined that were seen in two
// halves, only the one of the empty maze would.
#include <array>

#include "labmouse/mouse/seeker.hpp"
#include "labmouse/strategies/roster.hpp"

namespace labmouse {
namespace {

constexpr std::string_view method =
    "Goes by the shortest route to the cell, among those seen but not visited, that takes the fewest moves to reach, "
    "and chooses again. When it enters the goal, it resets and takes the shortest route that it has seen.";

constexpr std::string_view source = "FrontierBot in Edward Kish, section 4.5 (the third report).";

class Frontier final : public Seeker {
 public:
  Frontier(const Briefing& briefing, const Settings& settings) : Seeker(briefing, TieOrder(settings.choice("ties"))) {}

 private:
  int cost(Cell cell) const override { return routes().distance(cell); }
};

constexpr std::array parameters = {
    Parameter{
        "ties", ParameterType::choice, "wsen", 0, 0, TieOrder::all,
        "order of the directions among cells that are equally near, by compass (nesw) or as the mouse faces (alrb)"},
};

}  // namespace

constinit const RosterEntry frontier_mouse = {
    "frontier",
    "goes to the nearest cell that it has seen but not visited",
    method,
    source,
    parameters,
    [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<Frontier>(briefing, settings);
    }};

}  // namespace labmouse
