// Texts that describe layers: for legends, and for the lines below text drawings.
#pragma once

#include <string>
#include <string_view>

#include "labmouse/lab/drawing/drawing.hpp"
#include "labmouse/lab/drawing/legs.hpp"

namespace labmouse::drawing {

/// "17 steps, 45 cells".
std::string route_words(const std::vector<Leg>& legs);
/// "12 steps to the goal", and "9 steps from there on"; the reset does not count.
std::string to_goal_words(const SearchLegs& search_run);
std::string onwards_words(const SearchLegs& search_run);
/// "66 of 144 cells visited (45.8 %)", and the same for those discovered.
std::string visited_words(const ExploredCells& explored);
std::string discovered_words(const ExploredCells& explored);
/// Of the wrong walls: "3 wrong guesses: closed, never seen", or of a map that is compared with its maze "3 missed
/// walls: open in the map, closed in the maze".
std::string wrong_words(const DrawingLayers& layers);
/// "1 false wall: closed in the map, open in the maze".
std::string false_words(const WallSet& walls);
/// "14 candidates of step 12, with runs in steps"; "ways ahead" instead of "runs" if way_here is below 1.
std::string candidates_words(const StepReasons& choice);
/// "chosen: 17.4" (the cost of its run in steps), or "none chosen".
std::string chosen_words(const Reasons& reasons);
/// A candidate's run as a number of steps, "17.4".
std::string through_words(const Candidate& candidate, const Reasons& reasons);

}  // namespace labmouse::drawing
