// Shapes that occur only in contests in seconds.
#include "labmouse/lab/shapes/shapes.hpp"

namespace labmouse {

std::vector<Declaration> drive_shapes() {
  using namespace shapes;
  return {
      {"DriveScore",
       "What a run of a contest in seconds is worth by the rules, in microseconds; where dead ends count, `value` is "
       "the marks "
       "lost, in millionths.",
       object({field("gate_to_gate", or_null(number)), field("rest_to_centre", or_null(number)),
               field("maze_time", number,
                     "The part of the time in the maze before it that counts, and what is taken off for a mouse that "
                     "was not touched."),
               field("bonus", number), field("value", number),
               field("best", flag, "The one that counts in the end.")})},
      {"DriveRun", "One run of a contest in seconds. Times are microseconds on the maze's clock.",
       object(
           {field("kind", words({"search", "home", "speed", "laps"})), field("begin", number), field("end", number),
            field("gate_out", or_null(number),
                  "Left the start cell, first entered a goal, first in the middle of a goal; null where that never "
                  "came."),
            field("gate_in", or_null(number)), field("centre", or_null(number)),
            maybe("laps", list(number), "Of a run of laps: left the start cell again, after each lap."),
            maybe(
                "dead_ends",
                object({field("seen", number), field("all", number), field("steps", number),
                        field("fewest_steps", number)}),
                "Of a search that entered a goal, where dead ends count: what it saw before that, in how many steps."),
            field("known", or_null(number),
                  "When it began: times of the fastest route known to exist, and of the fastest that may exist; "
                  "null for none."),
            field("possible", or_null(number)),
            field("ended", or_null(text),
                  "How it ended, in the words of the record: \"done\", \"slid\", \"no route left\"; null in a world in "
                  "which nothing goes wrong."),
            field("crash", or_null(object({field("time", number), field("cell", named("Cell"))})),
                  "Where the mouse crashed, which ended the run; null where it did not."),
            field("frame", number, "The frame in which it begins."),
            field("from", number, "Its points in the path: from that one to the one before `to`."), field("to", number),
            field("score", or_null(named("DriveScore")), "Null where it does not count.")})},
      {"DrivePath",
       "A path, point by point. Between two points of a run the acceleration is even; turns have points dense enough "
       "to be drawn as lines. Where the speed leaps (robots with published times), two points have the same time.",
       object({field("t", list(number), "Microseconds."),
               field("x", list(number), "Cells from the south-west corner: the middle of cell (0,0) is (0.5, 0.5)."),
               field("y", list(number)),
               field("heading", list(number), "Eighths of a turn clockwise from north, without a leap within a run."),
               field("v", list(number), "mm/s."),
               field("a", list(number), "mm/s² along the path from this point to the next one.")})},
      {"DriveBodies",
       "Both mice of a contest in the physical world: the true one drives the path, the other one is where it believes "
       "to be. Lengths are in cells, times in microseconds.",
       object(
           {field("front", number, "From the middle of the axle."), field("back", number), field("half_width", number),
            field("rounding", number, "Radius of the corners."),
            field("belief",
                  object({field("x", list(number)), field("y", list(number)), field("heading", list(number))}),
                  "Of the path's points, one by one, headings without a leap from the true ones; without points of a "
                  "mouse whose program does not tell."),
            field("beams", list(object({field("ahead", number), field("left", number), field("angle", number)})),
                  "Where its infrared sensors are, and where they look: eighths of a turn clockwise from ahead."),
            field("distances", list(number),
                  "Of each point of the path one by each beam: how far the wall is that they read; 0 for none."),
            field(
                "looks",
                list(object({field("time", number), field("x", number), field("y", number), field("heading", number),
                             field("evidence", list(number))})),
                "What it read of the walls to the left, ahead and to the right of a cell as it entered it, in eighths "
                "of a nat: above 0 for a wall. Headings in eighths of a turn."),
            field("touches",
                  list(object({field("time", number), field("x", number), field("y", number), field("crash", flag)})),
                  "Where the true mouse touched a wall.")})},
      {"Drive", "What only a play in seconds has.",
       object(
           {field("robot", object({field("name", text), field("cell", number), field("hash", text)}),
                  "`cell`: the side of a cell in mm; `hash`: of its tables."),
            field("rules",
                  object({field("name", text), field("source", text), field("time_limit", number),
                          field("most_runs", number), field("maze_time_divisor", number),
                          field("touch_penalty", number), field("untouched_bonus", number), field("gate_to_gate", flag),
                          maybe("counts", words({"lap"}), "Where laps count, and not runs.")}),
                  "Times in microseconds. `maze_time_divisor`: 30 where a thirtieth of the time in the maze counts, 0 "
                  "where none does; `touch_penalty`: added to a run after a touch; `untouched_bonus`: taken off before "
                  "the first."),
            field("decisions", number), field("replanned", number), field("runs", list(named("DriveRun"))),
            field("path", named("DrivePath")),
            field("best", named("DrivePath"),
                  "The fastest run that the maze allows, from time 0; without points where there is none."),
            maybe("bodies", named("DriveBodies"), "Of a record in the physical world that has a trace.")})},
  };
}

}  // namespace labmouse
