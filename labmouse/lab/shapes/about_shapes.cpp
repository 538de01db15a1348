// Shapes of the answer to `about`: rules, worlds, mice and what else the core contains.
#include "labmouse/lab/shapes/shapes.hpp"

namespace labmouse {

std::vector<Declaration> about_shapes() {
  using namespace shapes;
  return {
      {"Rules", "", object({field("budget", number), field("search_factor", number), field("stride", number)})},
      {"ParameterType", "", words({"whole", "real", "flag", "choice", "list", "prior", "text"})},
      {"Parameter", "",
       object(
           {field("name", text), field("type", named("ParameterType")), field("default", text), field("meaning", text),
            maybe("low", number), maybe("high", number), maybe("choices", list(text)),
            maybe(
                "counts_in", words({"steps", "seconds", "errors"}),
                "Where it counts alone; missing where it counts everywhere. Errors: in worlds where things go wrong."),
            maybe("by_size", list(text), "The defaults in classic and in half-size mazes, if they differ."),
            maybe("listed", flag,
                  "Whether a race may have several values, separated by commas: it is then run once for each.")})},
      {"Mouse", "",
       object({field("name", text), field("summary", text), field("is_stochastic", flag),
               maybe("walks", flag, "Whether it plays in steps."),
               maybe("drives", flag, "Whether it drives in the worlds in seconds."),
               field("parameters", list(named("Parameter"))), maybe("method", text, "How it does that, in sentences."),
               maybe("source", text, "Where the idea comes from.")})},
      {"Named", "", object({field("name", text), field("summary", text)})},
      {"WorldInPage", "A world in which built-in mice race. The first one is meant where a race names none.",
       object(
           {field("name", text), field("summary", text),
            field("in_steps", flag, "Whether the user's own mice run there, and `losses` knows where steps are lost."),
            field("plays", flag, "Whether `contest` runs a contest there with its play."),
            field("is_stochastic", flag, "Whether contests differ for mice, too, that are deterministic themselves."),
            field("usual_runs", number, "Contests in each maze of a stochastic mouse or world, by default."),
            field("settings", list(named("Parameter")), "What a race there is asked besides."),
            field("mice", list(text))})},
      {"About", "`about`: what the core brings.",
       object(
           {field("version", text), field("compiler", text), field("mice", list(named("Mouse"))),
            field("mazes", list(object({field("name", text), field("width", number), field("height", number)}))),
            field("formats", list(named("Named"))), field("generators", list(named("Named"))),
            field("rules", object({field("failure_score", number)}, {"Rules"})),
            field("worlds", list(named("WorldInPage"))),
            field("parting",
                  object({field("world", text), field("mouse", text), field("maze", text), field("seed", number),
                          field("settings", named("Fields"))}),
                  "A contest to watch in which belief and truth part, and come together again."),
            field("most_side", number, "Largest side of a maze."),
            field("robots", list(object({field("name", text), field("cell", number)})),
                  "For contests in seconds: robots with the side of their cells in mm, and rules with their sources."),
            field("robot_keys", list(named("RobotKey")), "What may stand in a robot file, in the order of its form."),
            field("drive_rules", list(object({field("name", text), field("source", text)})))})},
  };
}

}  // namespace labmouse
