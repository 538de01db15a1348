// Shapes of a contest, frame by frame.
#include "labmouse/lab/shapes/shapes.hpp"

namespace labmouse {

std::vector<Declaration> play_shapes() {
  using namespace shapes;
  return {
      {"Candidate", "",
       object({field("wall", or_null(tuple({number, number, words({"north", "east"})})),
                     "The unseen wall as [x, y, side], or null for `goal`: entering the goal."),
               field("goal", flag), field("seen_from", named("Cell")),
               field("through", number, "Steps of the speed run through it, and steps of the way to it."),
               field("travel", number), field("worth", flag), field("score", number)})},
      {"Reasons", "",
       object({field("frame", number, "The frame before the step in which the mouse chose."),
               field("ground", text, "In words: what it went by."), field("candidates", list(named("Candidate"))),
               field("chosen", number, "Position of the chosen one; -1 for none."),
               field("known", number, "Steps of the best known run; 0 for none yet."), field("hope", number),
               field("price", number)})},
      {"MmsEvent",
       "Something that a program for mms drew; it holds from that frame on. A colour is a letter of mms, one of "
       "kbacgorwyBCAGORVY, a text at most two rows of five characters, the second right behind the first; '' is none.",
       either({object({field("frame", number), field("kind", word("wall")), field("cell", named("Cell")),
                       field("side", named("HeadingName")), field("there", flag)}),
               object({field("frame", number), field("kind", word("colour")), field("cell", named("Cell")),
                       field("colour", text)}),
               object({field("frame", number), field("kind", word("text")), field("cell", named("Cell")),
                       field("text", text)}),
               object({field("frame", number), field("kind", word("clear colours"))}),
               object({field("frame", number), field("kind", word("clear texts"))})})},
      {"Traits", "What the world of a contest is like, for those who show it.",
       object({field("clock", words({"steps", "seconds"}),
                     "What it counts. Where that is steps, each is a turn and a straight move."),
               field("unit", text, "Behind scores: \"s\"; empty where they need none."),
               field("digits", number, "Decimals of scores."), field("bound", text, "What the best possible score is."),
               field("runs", list(text), "What its runs are called, by the numbers in `run`: \"speed run\"."),
               field("draws", flag, "Whether the map of the mouse is what its program draws, and not `known`."),
               field("pictured", flag, "Whether `picture` draws its record.")})},
      {"Play",
       "One contest, frame by frame: frame 0 is before the first step, frame i after step i; the last is the end. "
       "Lists `clock`, `x`, `y`, `heading`, `run` have one entry a frame, those of steps one entry a step: step i "
       "leads from frame i to i + 1. In seconds a step is a move of a search, a straight or a turn, or being carried "
       "to the start.",
       object(
           {field("world", text, "Its name; what it is like stands in `traits`."),
            field("traits", named("Traits")),
            field("mouse", text),
            field("maze", named("MazeData")),
            field("rules", or_null(named("Rules")), "As in the record; only of a contest in steps."),
            field("seed", or_null(number)),
            field("outcome", text, "In words, with the reason of a forfeit."),
            field("finished", flag),
            field("score", or_null(number)),
            field("bound", or_null(number),
                  "The best possible score and speed run here (in seconds: from rest to the centre); null where there "
                  "is no way."),
            field("optimum", or_null(number)),
            field("search_steps", number),
            field("speed_steps", number),
            field("discovered", or_null(number), "Shares, 0 to 1, of the cells that can be reached; null in mms."),
            field("visited", or_null(number)),
            field("last_words", text, "From the program, for people: show it as text."),
            field("counts", list(object({field("name", text), field("value", number)}))),
            field("checked", text, "How far a record that lacks fields was checked; empty where it gives all."),
            field("ended", flag, "False where the record breaks off."),
            field("clock", list(number), "Steps or seconds, as `traits` says."),
            field("x", list(number), "In half cells: the centre of cell (0,0) is (1,1)."),
            field("y", list(number)),
            field("heading", list(number), "Eighths of a turn clockwise from north."),
            field("run", list(number), "The position of its name in `runs` of `traits`."),
            field(
                "action", list(text),
                "What was asked for, in words: \"right, 3\", \"ahead 2\", \"reset\", \"moveForward 2\", \"left V90\"."),
            field("blocked", list(flag), "A wall ended the movement early (in mms and in seconds: a crash)."),
            field("left", list(number),
                  "Open cells to the left, ahead and to the right before each step; empty in mms and in seconds."),
            field("ahead", list(number)),
            field("right", list(number)),
            field("known", list(number),
                  "By wall, 2 * cells: the north side of cell i at i, its east side at cells + i. The frame from which "
                  "the mouse knows that wall: the reading of a step is taken in the frame before it. The border is "
                  "known in frame 0; -1 never. In mms empty."),
            maybe("mistaken",
                  list(object({field("wall", number), field("closed", flag, "What it takes the wall for."),
                               field("from", number), field("to", or_null(number))})),
                  "Only of a mouse that can detect walls wrongly: walls, as above, that it takes for what they are "
                  "not, from a frame "
                  "on, up to another one or to the end. What it has only forgotten counts as taken for the same."),
            field("goal_frame", or_null(number),
                  "The first frame in the goal, and the one in which the mouse is back at the start; null where that "
                  "never came."),
            field("reset_frame", or_null(number)),
            field("entered", list(list(number)),
                  "Cells entered in each step (passing through counts), as positions in lists over cells; [] where it "
                  "stayed."),
            field("route", list(named("Cell")),
                  "The cells of a best possible speed run, one a step (in mms each cell on its way), from the start; "
                  "empty where there is no way."),
            field("distances", list(number),
                  "Steps (in mms cells) to the goal from each cell in the whole maze; -1 where there is no way."),
            field("reasons", list(named("Reasons"))),
            field("events", list(named("MmsEvent"))),
            field("loses", list(number),
                  "What each step falls behind a shortest way, in steps; after the goal each step of the search run "
                  "does. Empty where a step has no such measure."),
            field(
                "scores", list(or_null(number)),
                "What had been scored by each frame, whether or not it was finished in the end; in seconds null before "
                "the first run."),
            maybe("drive", named("Drive"), "Only in seconds."),
            maybe("again",
                  object({field("with", object({field("world", text), field("conditions", named("Fields"))})),
                          field("mice", list(text))}),
                  "How other mice have the same contest: what `contest` is asked besides, and who can. Missing where "
                  "none can.")})},
  };
}

}  // namespace labmouse
