// Shapes of races, reports and other answers.
#include "labmouse/lab/shapes/shapes.hpp"

namespace labmouse {

std::vector<Declaration> race_shapes() {
  using namespace shapes;
  return {
      {"RaceResults", "The results of a race as `labmouse race --format json` writes them.",
       object({field("labmouse", text), field("compiler", text), field("processor", text), field("seed", number),
               field("stopped", flag), field("groups", list(named("RaceGroup"))),
               field("skipped", list(object({field("path", text), field("reasons", list(text))})))})},
      {"Fields", "What else stands in results, by its key: figures that one world has, or what may be missing.",
       map(anything)},
      {"RacedMaze", "", object({field("name", text), field("width", number), field("height", number)}, {"Fields"})},
      {"ContestResult", "One contest in the results of a race; docs/reference/results.md has the fields.",
       object({field("maze", text), field("outcome", text)}, {"Fields"})},
      {"RacedMouse", "",
       object({field("name", text), field("runs", number), field("interval", or_null(tuple({number, number}))),
               field("mean_ratio", or_null(number)), field("results", list(named("ContestResult")))},
              {"Fields"})},
      {"RaceGroup", "A race in one world, best mouse first; `worlds.json` knows what else stands in it.",
       object({field("world", text), field("formula", text, "How its mice are scored, in one line."),
               maybe("notes", list(text),
                     "What `labmouse race` says below its table, line by line; missing in results of older versions."),
               field("mazes", list(named("RacedMaze"))), field("mice", list(named("RacedMouse")))},
              {"Fields"})},
      {"ShownColumn", "A column of a leaderboard, which shows a field of each mouse.",
       object({field("key", text, "The field: a number, or a list with both ends of an interval."),
               field("title", text), field("meaning", text), field("digits", number), maybe("factor", number),
               maybe("higher_is_better", flag)})},
      {"ShownWorld", "How races in a world are shown.",
       object({field("unit", text, "Of scores and their differences."),
               field("failure_score", or_null(number),
                     "What a contest without a score counts in means; null where it has no place there."),
               field("bound", text, "The field of a maze with its best possible score."), field("bound_meaning", text),
               field("columns", list(named("ShownColumn"))),
               maybe("score", object({field("key", text), field("inner", text), field("unit", number)}),
                     "Where it is not the field `score` of a contest: the field inside of which field, and what it is "
                     "multiplied by."),
               maybe("in_steps", flag, "Whether `losses` knows where its contests lose their steps."),
               maybe("plays", flag, "Whether `contest` runs a contest there again.")})},
      {"ShownWorlds", "`worlds.json`: the tables of all worlds that the core knows.",
       list(object({field("names", list(text)), field("table", named("ShownWorld"))}))},
      {"PairedDifference", "`compare`: what the differences of two mice in the same mazes show.",
       object({field("count", number), field("mean", number), field("interval", tuple({number, number})),
               field("below", number), field("equal", number), field("above", number), field("sign_test", number),
               field("p", number, "Of the sign-flip test, two-sided."),
               field("verdict", text, "better, worse, no difference shown, or too few mazes.")})},
      {"Opened", "`open`: what a dropped file turned out to be.",
       either({object({field("kind", word("maze")), field("maze", named("MazeData")),
                       field("notes", list(text), "What the user should know of how it was read, a sentence each.")}),
               object({field("kind", word("record")), field("play", named("Play"))}),
               object({field("kind", word("results")), field("results", named("RaceResults"))}),
               object({field("kind", word("robot")), field("name", text), field("text", text)})})},
      {"Report",
       "What a report page carries in its first block. The records are in the second, so that the table need not wait "
       "for them. `mazes`: by name, as the link of `link`.",
       object({field("labmouse", word("report")), field("format", exactly(2)), field("version", text),
               field("results", named("RaceResults")), field("mazes", map(text))})},
      {"ReportRecords", "The second block: records in their packed form, which only the core reads.",
       object({field("records", list(named("PackedRecord"))),
               field("left_out", number, "How many more there were that did not fit.")})},
      {"PackedRecord", "", object({field("mouse", text), field("maze", text), maybe("seed", number)}, {"Fields"})},
      {"Losses", "`losses`: where contests lose their steps.",
       object({field("contests", number), field("finished", number), field("bound", or_null(number)),
               field("mean_score", or_null(number)), field("search", list(number)), field("speed", list(number)),
               field("points", list(number))})},
      {"Failure", "How every call ends that did not succeed.",
       object({field("error", text), field("problems", list(named("Problem")))})},
  };
}

}  // namespace labmouse
