// Shapes of external programs that the page runs.
#include "labmouse/lab/shapes/shapes.hpp"

namespace labmouse {

std::vector<Declaration> external_shapes() {
  using namespace shapes;
  return {
      {"PlayedMouse",
       "A mouse that held its contests in the page before a race: one in each maze, with the seed of that race.",
       object({field("name", text), field("spec", text),
               field("contests",
                     list(object({field("record", text), field("started", flag), field("microseconds", number)})))})},
      {"ProgramLines", "What is to be said to the program of a contest, line by line, and how far the contest is.",
       object({field("contest", number), field("lines", list(text)), field("ended", flag), field("steps", number)})},
      {"ProgramEnd", "How a program ended that should not have. `line` is one of the program, from 1.",
       either({object({field("kind", word("failed")), field("message", text), maybe("line", number)}),
               object({field("kind", word("exited")), field("code", number)}),
               object({field("kind", word("silent")), field("seconds", number)}),
               object({field("kind", word("printed")), field("what", text)})})},
  };
}

}  // namespace labmouse
