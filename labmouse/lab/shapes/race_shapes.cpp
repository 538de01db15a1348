// Races, reports and what else is answered.
#include "labmouse/lab/shapes/shapes.hpp"

namespace labmouse {

std::vector<Declaration> race_shapes() {
  using namespace shapes;
  return {
      {"ContestResult", "One contest in the results of a race; docs/races.md has the fields.",
       object({field("maze", text), field("seed", number), field("outcome", text), field("score", or_null(number)),
               field("exploration_steps", number), field("speed_steps", or_null(number)),
               field("discovered_share", number), field("visited_share", number),
               field("microseconds_per_decision", number), maybe("blocked_steps", number),
               maybe("void_rotations", number), maybe("cut_movements", number), maybe("idle_resets", number),
               maybe("last_words", text), maybe("counts", map(number))})},
      {"RacedMouse", "",
       object({field("name", text), field("parameters", map(either({text, number, flag}))), field("contestant", flag),
               field("solved", number), field("runs", number), field("mean_score", or_null(number)),
               field("penalised_mean", or_null(number)), field("interval", or_null(tuple({number, number}))),
               field("mean_ratio", or_null(number)), field("mean_exploration_steps", or_null(number)),
               field("mean_speed_over_optimum", or_null(number)), field("optimal_share", number),
               field("mean_discovered_share", or_null(number)), field("mean_visited_share", or_null(number)),
               field("microseconds_per_decision", number), field("results", list(named("ContestResult")))})},
      {"RacedMaze", "",
       object({field("name", text), field("width", number), field("height", number), field("optimum", or_null(number)),
               field("bound", or_null(number))})},
      {"RaceResults", "The results of a race as `labmouse race --format json` writes them; mice come best first.",
       object({field("labmouse", text), field("compiler", text), field("processor", text), field("seed", number),
               maybe("budget", number, "Missing where no mouse raced by steps."), field("stopped", flag),
               field("mazes", list(named("RacedMaze"))), field("mice", list(named("RacedMouse"))),
               maybe("notes", list(text),
                     "What `labmouse race` says below its table, line by line; missing in results of older versions."),
               maybe("groups", list(named("RaceGroup")), "Races in other worlds."),
               field("skipped", list(object({field("path", text), field("reasons", list(text))})))})},
      {"Fields", "What else stands in results, by its key: figures that one world has, or what may be missing.",
       map(anything)},
      {"RaceGroup", "A race in one world; `race/worlds.ts` knows what else stands in it.",
       object({field("world", text), field("formula", text, "How its mice are scored, in one line."),
               field("mazes",
                     list(object({field("name", text), field("width", number), field("height", number)}, {"Fields"}))),
               field("mice",
                     list(object(
                         {field("name", text), field("runs", number),
                          field("interval", or_null(tuple({number, number}))), field("mean_ratio", or_null(number)),
                          field("results", list(object({field("maze", text), field("outcome", text)}, {"Fields"})))},
                         {"Fields"})))},
              {"Fields"})},
      {"PairedDifference", "`compare`: what the differences of two mice in the same mazes show.",
       object({field("count", number), field("mean", number), field("interval", tuple({number, number})),
               field("below", number), field("equal", number), field("above", number), field("sign_test", number)})},
      {"Opened", "`open`: what a dropped file turned out to be.",
       either({object({field("kind", word("maze")), field("maze", named("MazeData"))}),
               object({field("kind", word("record")), field("play", named("Play"))}),
               object({field("kind", word("results")), field("results", named("RaceResults"))}),
               object({field("kind", word("robot")), field("name", text), field("text", text)})})},
      {"Report",
       "What a report page carries in its first block. The records are in the second, so that the table need not wait "
       "for them. `mazes`: by name, as the link of `link`.",
       object({field("labmouse", word("report")), field("format", exactly(1)), field("version", text),
               field("results", named("RaceResults")), field("mazes", map(text))})},
      {"ReportRecords", "The second block: records in their packed form, which only the core reads.",
       object({field("records", list(named("PackedRecord"))),
               field("left_out", number, "How many more there were that did not fit.")})},
      {"PackedRecord", "", object({field("mouse", text), field("maze", text), maybe("seed", number)}, {"Fields"})},
      {"Losses", "`losses`: where contests lose their steps.",
       object({field("contests", number), field("solved", number), field("bound", or_null(number)),
               field("mean_score", or_null(number)), field("exploration", list(number)), field("speed", list(number)),
               field("points", list(number))})},
      {"Failure", "How every call ends that did not succeed.",
       object({field("error", text), field("problems", list(named("Problem")))})},
  };
}

}  // namespace labmouse
