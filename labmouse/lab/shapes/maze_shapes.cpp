// Shapes of mazes and of their problems.
#include "labmouse/lab/shapes/shapes.hpp"

namespace labmouse {

std::vector<Declaration> maze_shapes() {
  using namespace shapes;
  return {
      {"Cell", "", tuple({number, number})},
      {"HeadingName", "", words({"north", "east", "south", "west"})},
      {"MazeData", "A maze as the core gives and takes it.",
       object({field("name", text), field("width", number), field("height", number),
               field("walls", list(number),
                     "The closed sides of each cell: 1 north, 2 east, 4 south, 8 west. Two neighbours agree; the "
                     "border is closed."),
               field("start", named("Cell")), field("heading", named("HeadingName")),
               field("goals", list(named("Cell")))})},
      {"Problem",
       "What is wrong with an input. Line and column count from 1; 0 is the input as a whole, or a byte of a binary "
       "file.",
       object({field("line", number), field("column", number), field("reason", text)})},
      {"Inspection", "`inspect`: what a maze is like.",
       object(
           {field("optimum", or_null(number),
                  "Steps of the shortest speed run, and the score of a mouse that knows the maze; null where no goal "
                  "can be reached."),
            field("bound", or_null(number)), field("mms_run", or_null(number), "The same under mms's rules."),
            field("mms_score", or_null(number)), field("shortest_cells", or_null(number)),
            field("shortest_runs", or_null(number)), field("reachable", number), field("dead_ends", number),
            field("junctions", number), field("loops", number), field("left_follower_arrives", flag),
            field("right_follower_arrives", flag),
            field("contest_rules", list(object({field("name", text), field("passed", flag), field("reason", text)})),
                  "Each rule of the official contests, always all of them."),
            field("route", list(named("Cell")),
                  "The cells in which the steps of a shortest run end, the start first; empty where there is no way."),
            field("distances", list(number), "Steps to the goal from each cell; -1 where there is no way.")})},
  };
}

}  // namespace labmouse
