// Playthroughs that a person can read: every decision of every mouse in two tiny mazes, as files in tests/golden. A
// change of behaviour is a change of text. LABMOUSE_UPDATE_GOLDEN=1 writes them anew.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <sstream>

#include "labmouse/contest/score.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/strategies/builtin_mice.hpp"
#include "tests/drawn_maze.hpp"

namespace labmouse {
namespace {

struct TinyMaze {
  const char* name;
  const char* drawing;
};

/// A pocket that looks like the short way in, and a loop.
constexpr TinyMaze pocket = {"pocket", R"(
  o---o---o---o---o---o
  |                   |
  o   o---o---o---o   o
  |   |           |   |
  o   o---o   o   o   o
  |   |     G |   |   |
  o   o   o---o   o   o
  |       |       |   |
  o   o---o   o---o   o
  | S |               |
  o---o---o---o---o---o
)"};

/// Two ways: a crooked one of five steps, and a straight one round the outside of six.
constexpr TinyMaze stairs = {"stairs", R"(
  o---o---o---o---o---o---o
  |                       |
  o   o---o---o---o---o   o
  |   |       |       |   |
  o   o   o   o   o   o   o
  |   |   |     G         |
  o   o   o   o---o   o   o
  |       | G   G     |   |
  o   o   o---o---o---o   o
  |   |           |       |
  o   o---o---o   o---o   o
  | S |                   |
  o---o---o---o---o---o---o
)"};

std::string words_of(const Action& action) {
  if (action.kind == Action::Kind::reset) return "reset";
  if (action.kind == Action::Kind::forfeit) return "forfeit: " + std::string(name_of(action.reason));
  const std::string turn = action.rotation < 0 ? "turn left" : action.rotation > 0 ? "turn right" : "";
  const std::string go = action.movement < 0   ? "go back " + std::to_string(-action.movement)
                         : action.movement > 0 ? "go " + std::to_string(action.movement)
                                               : "";
  return turn.empty() && go.empty() ? "stay" : turn + (turn.empty() || go.empty() ? "" : ", ") + go;
}

std::string line_of(const StepRecord& step) {
  std::ostringstream line;
  line << std::setw(3) << step.step << "  " << std::left << std::setw(11)
       << (step.run == Run::speed ? "speed" : "search") << "  at (" << int{step.pose.cell.x} << ','
       << int{step.pose.cell.y} << ") " << std::setw(5) << name_of(step.pose.heading) << "  sees " << step.sighting.left
       << ' ' << step.sighting.ahead << ' ' << step.sighting.right << "  " << words_of(step.action)
       << (step.blocked ? " (blocked)" : "") << '\n';
  return line.str();
}

std::string playthrough(const BuiltinMouse& mouse, const TinyMaze& tiny) {
  const Maze maze = test::drawn(tiny.drawing);
  Rules rules;
  rules.budget = 40;  // enough for a person to read
  const auto strategy = mouse.make(brief(maze, rules, 1), Settings(mouse.parameters));
  const RunRecord record = run(maze, rules, *strategy);
  std::string text = std::string(mouse.name) + " in " + tiny.name + "\n\n" + test::unindented(tiny.drawing) + "\n";
  for (const StepRecord& step : record.steps) text += line_of(step);
  const Score result = score(record, rules);
  return text + "\n" + std::string(name_of(result.outcome)) + ": " + std::to_string(result.search_steps) +
         " search steps, " + std::to_string(result.speed_steps) + " speed steps\n";
}

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class Golden : public testing::TestWithParam<const BuiltinMouse*> {
 protected:
  static void plays_as_before(const TinyMaze& maze) {
    const std::string path =
        LABMOUSE_SOURCE_DIR "/tests/golden/" + std::string(GetParam()->name) + "-in-" + maze.name + ".txt";
    const std::string now = playthrough(*GetParam(), maze);
    if (std::getenv("LABMOUSE_UPDATE_GOLDEN") != nullptr) std::ofstream(path, std::ios::binary) << now;
    EXPECT_EQ(now, content_of(path)) << "not as in " << path
                                     << "; where that is meant, LABMOUSE_UPDATE_GOLDEN=1 writes it anew";
  }
};

TEST_P(Golden, ThePocketIsPlayedAsBefore) { plays_as_before(pocket); }

TEST_P(Golden, TheStairsArePlayedAsBefore) { plays_as_before(stairs); }

INSTANTIATE_TEST_SUITE_P(BuiltinMice, Golden, testing::ValuesIn(builtin_mice().begin(), builtin_mice().end()),
                         [](const auto& mouse) {
                           std::string name(mouse.param->name);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace labmouse
