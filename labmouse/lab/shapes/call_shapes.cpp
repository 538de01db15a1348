// The request and the answer of every call.
#include "labmouse/lab/shapes/shapes.hpp"

namespace labmouse {

std::vector<CallShape> call_shapes() {
  using namespace shapes;
  return {
      {"about", "", object({}), named("About")},
      {"signature", "The behaviour signature of `labmouse bench`.", object({}), object({field("signature", text)})},
      {"speed", "Nanoseconds of a distance field, as `labmouse bench` has them.", object({}),
       object({field("distance_ns", map(map(number)))})},
      {"builtin_maze", "", object({field("name", text)}), object({field("maze", named("MazeData"))})},
      {"make_maze", "`loops`: the share, 0 to 1, of the remaining inner walls to take away.",
       object({field("generator", text), field("width", number), field("height", number), field("seed", number),
               field("loops", number)}),
       object({field("maze", named("MazeData"))})},
      {"open", "A file of any kind, its content as bytes. A record without a maze takes `maze`.",
       object({field("name", text), maybe("maze", named("MazeData"))}), named("Opened"), CallBytes::some},
      {"inspect", "", object({field("maze", named("MazeData"))}), named("Inspection")},
      {"write_maze", "The maze as a file: text, or bytes for the binary format.",
       object({field("maze", named("MazeData")), field("format", text)}),
       object({field("file_name", text), maybe("text", text), maybe("bytes", list(number))})},
      {"link", "A maze as a text for links: letters, digits, - _ and . only; and back.",
       object({field("maze", named("MazeData"))}), object({field("link", text)})},
      {"read_link", "", object({field("link", text)}), object({field("maze", named("MazeData"))})},
      {"robot",
       "A robot that the page brings (`built_in`), with those values, or of the text in `bytes`; and the best route of "
       "a maze.",
       object({field("name", text), maybe("built_in", text), maybe("values", map(named("RobotValue"))),
               maybe("maze", named("MazeData"))}),
       named("RobotAnswer"), CallBytes::optional},
      {"regions",
       "Which route of a maze wins for which robot, as one or two numbers of it vary; the robot as for `robot`. The "
       "picture is that of `labmouse route --vary --svg`.",
       object({field("name", text), maybe("built_in", text), maybe("values", map(named("RobotValue"))),
               field("maze", named("MazeData")), field("vary", named("VariedRange")),
               maybe("and", named("VariedRange"))}),
       object({field("regions", named("RouteRegions")), field("svg", text)}), CallBytes::optional},
      {"contest",
       "A contest of a built-in mouse in any world, as `labmouse run MOUSE MAZE --seed N --explain`. The settings of "
       "the world stand beside `world`, by their names, as for `race`; or `conditions` are those of a race there, as "
       "results have them.",
       object({maybe("world", text), field("mouse", text), field("maze", named("MazeData")), field("seed", number),
               maybe("conditions", named("Fields"))},
              {"Fields"}),
       object({field("play", named("Play")), field("record", text)})},
      {"unpack", "A packed record of a report. A mouse of the built-in mice has its reasons again.",
       object({field("record", named("PackedRecord")), field("maze", named("MazeData"))}),
       object({field("play", named("Play")), field("record", text)})},
      {"race",
       "A race in the one thread that the page has: keep it small. Without mice: all of the built-in mice. The "
       "settings of "
       "its world stand beside `world`, by their names.",
       object({field("mice", list(text)), field("mazes", list(named("MazeData"))), field("seed", number),
               field("runs", number), maybe("world", text), maybe("played", list(named("PlayedMouse")))},
              {"Fields"}),
       object({field("results", named("RaceResults"))})},
      {"compare", "Means of a mouse in the same mazes as another.",
       object({field("differences", list(number)), maybe("seed", number)}), named("PairedDifference")},
      {"paired_shares",
       "Contests of one batch of a comparison, as those of `labmouse compare`: the share of the best possible score of "
       "each mouse in each maze, null where the maze does not count. `begin`: the number of its first maze, a multiple "
       "of "
       "32. With `mazes` these are drawn from; without, they are generated. The first mouse is compared with the "
       "others; "
       "those that are decided may be left out.",
       object({field("begin", number)}, {"ComparisonOrder", "Fields"}), object({field("shares", named("Shares"))})},
      {"verdict", "The comparison of mice by the shares of all batches so far. Once it is `over`, no more are needed.",
       object({field("shares", named("Shares"))}, {"ComparisonOrder", "Fields"}),
       object({field("comparison", named("Comparison")), field("over", flag)})},
      {"losses",
       "Where contests in steps in one maze lose their steps; labmouse/lab/replays/lost_steps.hpp says what that "
       "means. Lists run over cells; those that were not finished are left out of all but `contests`. `points` is "
       "what the mean contest loses of its score in that cell; they add up to `mean_score` - `bound`.",
       object({field("maze", named("MazeData")),
               field("contests", list(object({field("mouse", text), field("seed", number)}))),
               maybe("budget", number)}),
       named("Losses")},
      {"beliefs",
       "What a mouse with that knowledge believed: steps to the goal from each cell, all unknown walls open, frame by "
       "frame: frames * cells numbers of 16 bits in `bytes`, 65535 where there is no way.",
       object({field("maze", named("MazeData")), field("known", list(number)), field("frames", number),
               field("stride", number)}),
       object({field("bytes", bytes)})},
      {"picture", "A picture (SVG) of a maze, or of a record's text in `bytes`.",
       either({object({field("maze", named("MazeData"))}), object({})}), object({field("svg", text)}),
       CallBytes::optional},
      {"program_begin",
       "Begins a contest in steps of a program that the page runs. `name` may be empty; `spec` is the program for the "
       "command line. With `races` the seed is that of a race, from which the contest has its own.",
       object({field("name", text), field("spec", text), field("maze", named("MazeData")), field("seed", number),
               maybe("races", flag), maybe("budget", number)}),
       named("ProgramLines")},
      {"program_hear",
       "What the program wrote, to its standard output and to its standard error, with all line ends; or how it ended.",
       object({field("contest", number), maybe("output", text), maybe("printed", text),
               maybe("end", named("ProgramEnd"))}),
       named("ProgramLines")},
      {"program_end", "Ends a contest, which counts as interrupted where it was not over.",
       object({field("contest", number)}),
       object({field("play", named("Play")), field("record", text), field("packed", named("PackedRecord")),
               field("started", flag), field("microseconds", number)})},
      {"live_begin",
       "Begins to read a real robot, in a maze that is known (`maze`) or of that size. With `robot`, its name, it is "
       "given as for `robot`, and the routes of the map are planned.",
       object({maybe("maze", named("MazeData")), maybe("width", number), maybe("height", number), maybe("robot", text),
               maybe("built_in", text), maybe("values", map(named("RobotValue")))}),
       named("LiveState"), CallBytes::optional},
      {"live_feed", "The next bytes of the robot, in any pieces.", object({field("stream", number)}),
       named("LiveState"), CallBytes::some},
      {"live_end", "", object({field("stream", number)}), object({})},
  };
}

}  // namespace labmouse
