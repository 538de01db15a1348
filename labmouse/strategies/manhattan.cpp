// manhattan: to the cell that looks nearest to the goal.
//
// Limits: keeps crossing the maze where two regions near the goal are both closed to it, and seldom looks at the edge,
// where many a maze has its way in.
// Choices: what it shares with the report's other seeker, see Seeker; with that, frontier has all its scores. This
// mouse has not, and no order, metric or end of the exploration that was tried gives them: here they are 1.4 below, 0.2
// above, 2.0 above and, in the empty maze, 0.1 below. There the report's takes three steps more, as if it had to stand
// in all four goal cells; but then the others still do not all come out.
#include "labmouse/mouse/manhattan.hpp"

#include <array>

#include "labmouse/mouse/seeker.hpp"
#include "labmouse/strategies/roster.hpp"

namespace labmouse {
namespace {

constexpr std::string_view method =
    "Goes by the shortest route to the cell, among those seen but not visited, with the smallest Manhattan distance to "
    "a goal cell, and chooses again. When it enters the goal, it resets and takes the shortest route that it has seen.";

constexpr std::string_view source = "ManhattanBot in Edward Kish, section 4.4 (the third report).";

class Manhattan final : public Seeker {
 public:
  Manhattan(const Briefing& briefing, const Settings& settings) : Seeker(briefing, TieOrder(settings.choice("ties"))) {}

 private:
  int cost(Cell cell) const override { return manhattan_to(briefing().goals, cell); }
};

constexpr std::array parameters = {
    Parameter{"ties", ParameterType::choice, "wsen", 0, 0, TieOrder::all,
              "order of the directions in a reading and in the search for a route, by compass (nesw) or as the mouse "
              "faces (alrb)"},
};

}  // namespace

constinit const RosterEntry manhattan_mouse = {
    "manhattan",
    "goes to the unvisited cell that looks nearest to the goal",
    method,
    source,
    parameters,
    [](const Briefing& briefing, const Settings& settings) -> std::unique_ptr<Strategy> {
      return std::make_unique<Manhattan>(briefing, settings);
    }};

}  // namespace labmouse
