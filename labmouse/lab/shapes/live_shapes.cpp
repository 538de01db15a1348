// Shapes of what a real robot sends.
#include "labmouse/lab/shapes/shapes.hpp"

namespace labmouse {

std::vector<Declaration> live_shapes() {
  using namespace shapes;
  return {
      {"LiveFinding", "What a user should know of a line. `side` is of a wall, seen from `cell`.",
       object(
           {field("kind", words({"restart", "outside", "open_border", "contradiction", "false_wall", "missed_wall"})),
            field("line", number), field("cell", or_null(named("Cell"))), field("side", or_null(named("HeadingName"))),
            field("words", text, "The line of `labmouse live`.")})},
      {"LiveState", "What a real robot has sent so far.",
       object({field("stream", number),
               field("maze", named("MazeData"), "The map; walls that it has not seen are open."),
               field("unseen", list(number), "The unseen walls of each cell: 1 north, 2 east."),
               field("drawing", text, "The map as `labmouse live --save` writes it."),
               field("pose", or_null(object({field("cell", named("Cell")), field("heading", named("HeadingName"))}))),
               field("route", list(named("Cell")), "The route that the robot plans: its cell, then where it turns."),
               field("fields", map(text), "The newest value of each field."),
               field("values",
                     list(object({field("line", number), field("v", or_null(number), "mm/s"),
                                  field("batt", or_null(number), "mV")})),
                     "Of the lines that this call read."),
               field("findings", list(named("LiveFinding")), "Of the lines that this call read."),
               field("contradictions", list(named("LiveFinding"))),
               field("wrong", list(named("LiveFinding")), "False and missed walls of the map."),
               field("advice", text, "What `labmouse live --robot` prints; empty without a robot."),
               field("plan", text, "The line for the robot; empty if no route is known."), field("lines", number),
               field("noise", number), field("restarts", number)})},
  };
}

}  // namespace labmouse
