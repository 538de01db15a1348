// Shapes of a robot in the editor, and of the model computed from it.
#include "labmouse/lab/shapes/shapes.hpp"

namespace labmouse {

std::vector<Declaration> robot_shapes() {
  using namespace shapes;
  const Shape wall = tuple({number, number, number, number});
  return {
      {"RobotKey", "A number of a robot file.",
       object({field("name", text, "With its section: `straight.speed`."), field("meaning", text), field("unit", text),
               field("range", text, "In words, with the unit."), field("low", number), field("high", number),
               field("with", words({"always", "curves", "turns", "search_speed", "search_times", "body"}),
                     "In which forms of the file it has a meaning."),
               field("needed", flag), field("kind", words({"number", "whole", "number_or_false", "yes_or_no", "end"})),
               field("of_diagonals", flag)})},
      {"RobotValue", "", either({number, flag, text})},
      {"RobotTurn",
       "A kind of turn: its path and what it takes. Lengths in mm, null where only times are known; places in cells.",
       object({field("turn", text),
               field("speeds", list(object({field("speed", number), field("ms", number)})), "The fastest first."),
               field("path", list(named("Cell")), "Through two cells by two: the lead, the curve, the lead."),
               field("open", list(wall),
                     "Walls from post to post as [x, y, x, y]: those that must be open, and those that may stand."),
               field("standing", list(wall)), field("lead_in", or_null(number)), field("lead_out", or_null(number)),
               field("length", or_null(number)), field("clearance", or_null(number))})},
      {"RobotResult", "What follows from a robot; times in milliseconds.",
       object(
           {field("line", text, "In one line."), field("turns", list(named("RobotTurn"))),
            field("straights",
                  list(object({field("kind", text), field("step", text), field("speed", number),
                               field("times", list(object({field("steps", number), field("ms", number)})))})),
                  "From one turn at `speed` to the next: so many steps of that length in so many milliseconds."),
            field("search",
                  object({field("cell", number), field("turn", number), field("back", number), field("quarter", number),
                          field("half_cell", number), field("known_2", number), field("known_8", number)}),
                  "The moves of a search."),
            field("tables", text, "The hash of its tables.")})},
      {"RobotRoute", "The fastest route of a maze as `labmouse route --format json` has it; times in microseconds.",
       object({field("name", text), field("time_us", number), field("gate_to_gate_us", number),
               field("without_diagonals_us", or_null(number)), field("diagonal_gain", or_null(number)),
               field("small_turns_us", or_null(number)), field("gain_over_small_turns", or_null(number)),
               field("cells", number), field("fewest_cells", number), field("fewest_cells_us", or_null(number)),
               field("route", text), field("segments", list(anything)), field("path", named("DrivePath"))})},
      {"VariedRange", "A number of a robot by its key, in the key's unit, and how far it is varied.",
       object({field("key", text), field("from", number), field("to", number)})},
      {"RouteRegion",
       "Where one route stays the fastest, from the first value planned to the last; null where none is.",
       either({object({field("from", number), field("to", number), field("route", text), field("time_from_us", number),
                       field("time_to_us", number), field("runner_up", or_null(text)),
                       field("margin", or_null(number), "By how much the best other route is slower.")}),
               object({field("from", number), field("to", number), field("route", null), field("refusal", text)})})},
      {"RouteRegions", "Which route wins for which robot, as `labmouse route --vary --format json` has it.",
       object({field("labmouse", text), field("robot", text), field("maze", text),
               field("vary", object({field("unit", text)}, {"VariedRange"})),
               field("and", or_null(object({field("unit", text)}, {"VariedRange"}))), field("plans", number),
               field("routes", list(object({field("name", text), field("cells", number), field("route", text),
                                            field("passes", list(tuple({number, number, text})))}))),
               field("rows",
                     list(object({field("at", or_null(number)), field("regions", list(named("RouteRegion")))})))})},
      {"RobotSentence", "A sentence about a robot, and the key that it belongs to; empty for none.",
       object({field("key", text), field("text", text)})},
      {"RobotAnswer",
       "`robot`: the text of its file, what stands there, and what follows; `result` is null where there are problems.",
       object({field("text", text), field("values", map(named("RobotValue"))),
               field("keys", list(text), "Those that have a meaning beside those values."),
               field("problems", list(object({field("line", number), field("column", number)}, {"RobotSentence"}))),
               field("remarks", list(named("RobotSentence"))), field("result", or_null(named("RobotResult"))),
               field("route", or_null(named("RobotRoute"))),
               field("no_route", text, "Why there is none in that maze; empty where nothing is wrong.")})},
  };
}

}  // namespace labmouse
