// An external mouse that somebody else runs: heard word by word, it has the contest that the same words have from a
// process.
#include "labmouse/external/dialogue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/contest/simulator.hpp"
#include "labmouse/external/external_strategy.hpp"
#include "tests/drawn_maze.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;

const Maze& corridor() {
  static const Maze maze = test::drawn(R"(
      o---o---o---o
      | S       G |
      o---o---o---o
  )");
  return maze;
}

/// What an external mouse says: its greeting and answers, each once it is asked; the last piece may be anything.
using Said = std::vector<std::string>;

/// By a process that says the next piece at the greeting and at each question.
RunRecord by_process(const Said& said) {
  std::string script;
  for (std::size_t i = 0; i < said.size(); ++i) {
    if (i > 0) script += "until [ \"${line%% *}\" = sense ]; do read -r line || exit 0; done; line=; ";
    script += "printf '%b' '" + said[i] + "'; ";
  }
  Launch launch;
  launch.words = {"sh", "-c", script + "cat > /dev/null"};
  ExternalStrategy strategy(launch, brief(corridor(), Rules(), 7));
  return run(corridor(), Rules(), strategy);
}

std::string unescaped(std::string text) {
  for (std::size_t at; (at = text.find("\\n")) != std::string::npos;) text.replace(at, 2, "\n");
  return text;
}

RunRecord by_dialogue(const Said& said) {
  Dialogue dialogue(corridor(), Rules(), 7);
  for (const std::string& piece : said) dialogue.hear(unescaped(piece));
  EXPECT_TRUE(dialogue.contest().ended());
  return dialogue.take_record();
}

TEST(Dialogue, HasTheRecordOfAProcess) {
  const std::string long_line(5000, 'x');
  const std::vector<Said> external_mice = {
      {"labmouse 1\\n", "move 90 2\\n", "reset\\n", "move 90 2\\n"},
      {"labmouse 1\\n", "move 90 2\\n", "fly\\n"},
      {"labmouse 1\\n", "move 90 2\\n", "forfeit\\n"},
      {"labmouse 1\\n", "move 90 1\\nmove 0 1\\n"},
      {"labmouse 2\\n"},
      {"wallLeft\\n"},
      {"labmouse 1\\n", long_line + "\\n"},
  };
  for (const Said& said : external_mice) EXPECT_EQ(by_dialogue(said), by_process(said)) << testing::PrintToString(said);
}

TEST(Dialogue, SaysTheBriefingThenAQuestionForEachAnswer) {
  Dialogue dialogue(corridor(), Rules(), 7);
  EXPECT_EQ(dialogue.take_lines(),
            "labmouse 1\nsize 3 1\nstart 0 0 north\ngoal 2 0\nstride 3\nbudget 1000\nseed 7\nbegin\n");
  EXPECT_EQ(dialogue.take_lines(), "");
  dialogue.hear("labmouse");
  EXPECT_EQ(dialogue.take_lines(), "");
  dialogue.hear(" 1\n");
  EXPECT_EQ(dialogue.take_lines(), "sense 0 0 2\n");
  dialogue.hear("move 90 1\r\n");
  EXPECT_EQ(dialogue.take_lines(), "sense 0 1 0\n");
}

TEST(Dialogue, KeepsTheLastOfWhatItPrinted) {
  Dialogue dialogue(corridor(), Rules(), 7);
  dialogue.hear_errors(std::string(5000, 'a') + "\nend\n");
  dialogue.hear("labmouse 1\nforfeit\n");
  const std::string words = dialogue.take_record().last_words;
  EXPECT_THAT(words, Says("answered `forfeit`", "aaa\nend"));
  EXPECT_LT(words.size(), 4200U);
}

TEST(Dialogue, ForfeitsWithTheReasonOfItsEnd) {
  using Kind = ProgramEnd::Kind;
  const auto forfeits = [](const ProgramEnd& end, const char* greeting = "labmouse 1\n") {
    Dialogue dialogue(corridor(), Rules(), 7);
    dialogue.hear(greeting);
    dialogue.give_up(end);
    RunRecord record = dialogue.take_record();
    EXPECT_EQ(record.outcome, Outcome::forfeit);
    return std::pair(record.steps.back().action.reason, record.last_words);
  };
  const auto [died, how] = forfeits({Kind::exited, "an error in line 3: x is not defined"});
  EXPECT_EQ(died, ForfeitReason::ended_early);
  EXPECT_THAT(how, Says("an error in line 3: x is not defined"));
  EXPECT_THAT(forfeits({Kind::exited, "exit code 0"}, "").second, Says("exit code 0", "before", "'labmouse 1'"));
  EXPECT_EQ(forfeits({Kind::silent, "2 s"}).first, ForfeitReason::hung);
  EXPECT_THAT(forfeits({Kind::silent, "2 s"}, "labmouse 1\nmove 9").second, Says("2 s", "'move 9'", "ending the line"));
  EXPECT_EQ(forfeits({Kind::printed, "too much"}).first, ForfeitReason::too_much_written);
  EXPECT_EQ(forfeits({Kind::interrupted, ""}).first, ForfeitReason::interrupted);
}

TEST(Dialogue, HearsNothingAfterItsEnd) {
  Dialogue dialogue(corridor(), Rules(), 7);
  dialogue.hear("labmouse 1\nforfeit\n");
  dialogue.hear("move 0 1\n");
  dialogue.give_up({ProgramEnd::Kind::silent, "2 s"});
  EXPECT_EQ(dialogue.take_lines(), "");
  const RunRecord record = dialogue.take_record();
  EXPECT_EQ(record.steps.size(), 1U);
  EXPECT_EQ(record.steps.back().action.reason, ForfeitReason::gave_up);
}

}  // namespace
}  // namespace labmouse
