// The bridge to capstone robots, under Python 3 and, where there is one, Python 2.7.
#include "labmouse/external/capstone.hpp"

#include <gmock/gmock.h>

#include <functional>

#include "tests/external/capstone_fixture.hpp"
#include "tests/says.hpp"
#include "tests/slowness.hpp"

namespace labmouse {
namespace {

using test::ARobot;
using test::ARobotWithNumpy;
using test::Says;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr Action reset = Action::reset();
constexpr Action step(int rotation, int movement) { return Action::step(rotation, movement); }

/// Ended in that step as an external mouse that died, with these last words.
void expect_died(const RunRecord& record, std::size_t in_step, const testing::Matcher<const std::string&>& words) {
  EXPECT_EQ(record.outcome, Outcome::forfeit);
  EXPECT_EQ(record.steps.size(), in_step);
  EXPECT_EQ(record.steps.back().action, Action::forfeit(ForfeitReason::ended_early));
  EXPECT_THAT(record.last_words, AllOf(HasSubstr("exit code "), words));
}

// What it is told and answers.

TEST_P(ARobot, SolvesAMaze) {
  const RunRecord record = contest(R"(
    class Robot(object):
        def __init__(self, maze_dim):
            self.moves = [(90, 2), (0, 0), ('Reset', 'Reset'), (90, 3)]
        def next_move(self, sensors):
            return self.moves.pop(0)
  )");
  EXPECT_EQ(record.outcome, Outcome::finished);
  EXPECT_THAT(actions(record), ElementsAre(step(90, 2), step(0, 0), reset, step(90, 3)));
  EXPECT_EQ(record.last_words, "");
}

TEST_P(ARobot, IsToldTheWidthAndItsReadingsAsWholeNumbers) {
  const RunRecord record = contest_by(R"(
    sensors = [type(self.dim) is int and self.dim] + [type(s) is int and s for s in sensors]
    return sensors[self.n - 1], 0
  )",
                                      4);
  EXPECT_THAT(actions(record), ElementsAre(step(3, 0), step(0, 0), step(0, 0), step(2, 0)));
}

TEST_P(ARobot, IsReadAsTheTesterOfTheProjectReadsIt) {
  const RunRecord record = contest(R"(
    class Number(object):  # as those of numpy
        def __init__(self, number):
            self.number = number
        def __eq__(self, other):
            return self.number == other
        def __int__(self):
            return int(self.number)
        def __abs__(self):
            return abs(self.number)

    class Robot(object):
        def __init__(self, maze_dim):
            nan, infinite, huge = float('nan'), float('inf'), 10 ** 30
            self.moves = [
                (90.0, 1.0), (-90, 2.9), (0, -2.9), (Number(90), Number(1.5)), [0, 1],
                (False, True), (True, False), (45, 1), (-45.0, 1), (180, 1), (90.5, 1), (huge, -huge), (1e30, 1e30),
                (nan, 1), (infinite, 1), (None, 1), ('90', 1), ('right', 1), ((), 1), ('Reset', 0),
                (u'Reset', u'Reset'), ['Reset', 'Reset']]
        def next_move(self, sensors):
            return self.moves.pop(0)
  )",
                                   22);
  EXPECT_THAT(
      actions(record),
      ElementsAre(step(90, 1), step(-90, 2), step(0, -2), step(90, 1), step(0, 1), step(0, 1), step(1, 0), step(45, 1),
                  step(-45, 1), step(180, 1), step(1, 1), step(1'000'000, -1'000'000), step(1'000'000, 1'000'000),
                  step(1, 1), step(1, 1), step(1, 1), step(1, 1), step(1, 1), step(1, 1), step(1, 0), reset, reset));
}

TEST_P(ARobot, DiesOfAnAnswerOfWhichTheTesterWouldDie) {
  for (const char* answer : {"None", "5", "'Reset'", "(0,)", "(0, 1, 2)", "(0, '1')", "(0, None)", "(0, 'Reset')",
                             "('reset', 'reset')", "(0, float('nan'))", "(0, float('inf'))", "(0, [1])", "(0, 1j)"}) {
    SCOPED_TRACE(answer);
    expect_died(contest_by(std::string("return ") + answer), 1, Says("(rotation, movement)", "('Reset', 'Reset')"));
  }
}

TEST_P(ARobot, HearsWhatItReturned) {
  expect_died(contest_by("return (0, 'one')"), 1, HasSubstr("next_move returned (0, 'one')"));
  expect_died(contest_by("return ('x' * 9999,)"), 1, Says("next_move returned ('xxx", "(rotation, movement)"));
}

// What else it writes and reads.

TEST_P(ARobot, PrintsIntoTheLogAndNotIntoTheProtocol) {
  const RunRecord record = contest(R"(
    import os, subprocess, sys
    print('move 0 3')

    class Robot(object):
        n = 0
        def __init__(self, maze_dim):
            print('forfeit')
        def next_move(self, sensors):
            self.n += 1
            print('move 0 1')
            sys.stdout.write('no end of line')
            sys.stdout.flush()
            sys.__stdout__.write('reset\n')
            os.write(1, b'reset\n')
            subprocess.check_call(['echo', 'reset'])
            return (90, 0) if self.n < 4 else 1 / 0
  )");
  expect_died(record, 4, AllOf(HasSubstr("forfeit\n"), HasSubstr("no end of line"), HasSubstr("ZeroDivisionError")));
  EXPECT_EQ(record.steps[2].action, step(90, 0));
}

TEST_P(ARobot, MayPrintMoreThanAPipeHolds) {
  const RunRecord record = contest_by("print('x' * 300000)\nreturn 90, 0", 3);
  EXPECT_THAT(actions(record), ElementsAre(step(90, 0), step(90, 0), step(90, 0)));
}

TEST_P(ARobot, ReadsAnEmptyInput) {
  const RunRecord record = contest_by(R"(
    import os, sys
    ask = input if sys.version_info[0] > 2 else raw_input
    try:
        ask()
    except EOFError:
        return 90, len(sys.stdin.read()) + len(os.read(0, 9))
  )",
                                      2);
  EXPECT_THAT(actions(record), ElementsAre(step(90, 0), step(90, 0)));
}

// Where it lies.

TEST_P(ARobot, RunsInItsFolderWithWhatLiesBesideIt) {
  file("helper.py", "MOVES = [(90, 1)]\n");
  file("late.py", "");
  file("moves.txt", "90 2\n");
  const RunRecord record = contest(R"(
    import os, sys
    from helper import MOVES
    import helper
    SELF = sys.modules[__name__]

    class Robot(object):
        def __init__(self, maze_dim):
            self.moves = MOVES + [tuple(int(word) for word in line.split()) for line in open('moves.txt')]
            here = os.path.dirname(__file__) == os.getcwd() and SELF.Robot is Robot
            self.moves.append((90, 3 if here else 0))
        def next_move(self, sensors):
            os.chdir('/')
            import late
            return self.moves.pop(0)
  )",
                                   3);
  EXPECT_THAT(actions(record), ElementsAre(step(90, 1), step(90, 2), step(90, 3))) << record.last_words;
}

TEST_P(ARobot, LeavesNothingInItsFolder) {
  unsetenv("PYTHONDONTWRITEBYTECODE");
  file("helper.py", "");
  const RunRecord record = contest(
      "import helper\nclass Robot:\n    def __init__(self, dim): pass\n    next_move = lambda self, s: (0, 0)\n", 1);
  EXPECT_EQ(record.outcome, Outcome::out_of_steps) << record.last_words;
  for (const auto& left : std::filesystem::directory_iterator(folder_))
    EXPECT_THAT(left.path().filename(), testing::AnyOf("robot.py", "helper.py"));
}

TEST_P(ARobot, MayHaveAnyFileName) {
  const char* code =
      "class Robot:\n    def __init__(self, dim): pass\n    def next_move(self, sensors): return 90, 0\n";
  for (const char* name : {"my-robot v2.final.py", "robot.txt", "robot", "-c.py", "m\u00e4use.py"}) {
    SCOPED_TRACE(name);
    const RunRecord record = contest_of(file(name, code), 2);
    EXPECT_THAT(actions(record), ElementsAre(step(90, 0), step(90, 0))) << record.last_words;
  }
}

TEST_P(ARobot, IsNotTheProgram) {
  EXPECT_EQ(contest("class Robot:\n    def __init__(self, dim): pass\n    def next_move(self, sensors): return 90, 0\n"
                    "if __name__ == '__main__': raise SystemExit('run')\n",
                    2)
                .outcome,
            Outcome::out_of_steps);
}

// How it dies.

TEST_P(ARobot, WithoutTheClassIsSaidToHaveNone) {
  expect_died(contest("class Rowboat(object): pass\n"), 1,
              Says("exit code 1 ", " Robot of robot.py was made\n", "robot.py has no class Robot"));
}

TEST_P(ARobot, WithASyntaxErrorIsShownItsLine) {
  expect_died(contest("class Robot(object):\n    def next_move(self sensors):\n"), 1,
              AllOf(HasSubstr("robot.py\", line 2"), HasSubstr("SyntaxError")));
}

TEST_P(ARobot, WhoseModuleFailsIsShownWhere) {
  expect_died(contest("import no_such_module\n"), 1,
              AllOf(HasSubstr("robot.py\", line 1"), HasSubstr("no_such_module")));
}

TEST_P(ARobot, WhoseConstructorThrowsIsShownWhere) {
  expect_died(contest("class Robot(object):\n    def __init__(self, dim):\n        raise ValueError('dim %d' % dim)\n"),
              1, AllOf(HasSubstr("robot.py\", line 3, in __init__"), HasSubstr("ValueError: dim 3")));
}

TEST_P(ARobot, ThatIsNotReadyInTimeIsNotToldOfAProtocol) {
  options_.limits.start = std::chrono::milliseconds(1);
  const RunRecord record = contest("import time\ntime.sleep(60)\n");
  EXPECT_THAT(record.last_words, Says("--start-limit", " Robot of robot.py was made"));
}

TEST_P(ARobot, WhoseConstructorTakesNoSizeIsToldHowItIsCalled) {
  expect_died(contest("class Robot(object):\n    def __init__(self): pass\n"), 1,
              AllOf(Says("TypeError", "Robot(maze_dim)", "next_move(sensors)"), Not(HasSubstr("<string>"))));
}

TEST_P(ARobot, WithoutNextMoveDies) {
  expect_died(contest("class Robot(object):\n    def __init__(self, dim): pass\n"), 1, HasSubstr("next_move"));
}

TEST_P(ARobot, ThatRaisesInAStepEndsInThatStep) {
  expect_died(contest_by("if self.n == 5: raise KeyError('five')\nreturn 90, 0"), 5,
              AllOf(HasSubstr("robot.py\", line 7, in next_move"), HasSubstr("KeyError: 'five'")));
}

TEST_P(ARobot, ThatExitsEndsInThatStepWithItsCode) {
  for (const auto& [call, code] :
       {std::pair("sys.exit()", "exit code 0"), std::pair("sys.exit(3)", "exit code 3"),
        std::pair("os._exit(4)", "exit code 4"), std::pair("sys.exit('enough')", "exit code 1\nenough")}) {
    SCOPED_TRACE(call);
    expect_died(contest_by(std::string("import os, sys\nif self.n == 5: ") + call + "\nreturn 90, 0"), 5,
                HasSubstr(code));
  }
}

TEST_P(ARobot, ThatIsKilledIsSaidToBe) {
  const RunRecord record = contest_by("import os\nif self.n == 2: os.kill(os.getpid(), 11)\nreturn 90, 0");
  EXPECT_EQ(record.steps.back().action, Action::forfeit(ForfeitReason::ended_early));
  EXPECT_THAT(record.last_words, HasSubstr("signal 11"));
}

TEST_P(ARobot, ThatLeavesAProgramBehindHasDiedAllTheSame) {
  expect_died(contest_by("import subprocess\nsubprocess.Popen(['sleep', '600'])\nreturn 1 / 0"), 1,
              HasSubstr("ZeroDivisionError"));
}

TEST_P(ARobot, KeepsTheLastOfMuchThatItSaid) {
  const RunRecord record = contest_by("print('first')\nprint('x' * 99999)\nprint('last')\nraise SystemExit(1)");
  expect_died(record, 1, AllOf(HasSubstr("xxx\nlast"), Not(HasSubstr("first"))));
  EXPECT_LT(record.last_words.size(), 5000U);
}

// What to do about it.

TEST_P(ARobot, OfTheOtherPythonIsToldWhichToName) {
  using Codes = std::vector<const char*>;
  const bool under_2 = std::string(GetParam()) == "python2";
  const Codes of_2 = {"print 'go'\n",
                      "try:\n    pass\nexcept ValueError, e:\n    pass\n",
                      "raise ValueError, 'no'\n",
                      "raw_input()\n",
                      "xrange(3)\n",
                      "unicode('a')\n",
                      "import Queue\n",
                      "{}.has_key(1)\n"};
  const Codes of_3 = {"print('go', end='')\n", "name = f'{1}'\n", "def go(to: int): pass\n", "import queue\n"};
  for (const char* code : under_2 ? of_3 : of_2) {
    SCOPED_TRACE(code);
    const std::string python = under_2 ? "--python python3" : "--python python2.7";
    expect_died(contest(code), 1, Says(under_2 ? "for Python 3" : "for Python 2", python));
  }
}

TEST_P(ARobot, WithMistakesOfItsOwnIsNotSentToTheOtherPython) {
  for (const char* code : {"print('go'\n", "prnt('go')\n", "import no_such_module\n", "[].iter()\n", "raise 1\n",
                           "class Robot(object):\n    def __init__(self): pass\n"}) {
    SCOPED_TRACE(code);
    expect_died(contest(code), 1, Not(HasSubstr("written for")));
  }
}

TEST_P(ARobot, ThatLacksAModuleIsToldWhichPythonItRanUnder) {
  expect_died(contest("import no_such_module.part\n"), 1, Says("no_such_module", "installed", "python", "--python"));
}

// Chance, in the ways of students.

/// Robots that turn by chance; a way defines turn(robot), which may use robot.n and what set_up(robot) left.
std::string robot_turning(const std::string& way) {
  return "def set_up(robot): pass\n" + way +
         "class Robot(object):\n    n = 0\n    def __init__(self, maze_dim):\n        set_up(self)\n"
         "    def next_move(self, sensors):\n        self.n += 1\n        return turn(self), 0\n";
}

/// The contests of a seed give one record again and again, and those of another seed another one.
void expect_repeats(const std::function<RunRecord(std::uint64_t seed)>& contest) {
  const RunRecord first = contest(1);
  EXPECT_EQ(first.outcome, Outcome::out_of_steps) << first.last_words;
  for (int again = 0; again < 2; ++again) EXPECT_EQ(contest(1), first);
  EXPECT_NE(contest(2).steps, first.steps);
}

TEST_P(ARobot, ThrowsTheSameDiceInTheSameContest) {
  const std::vector<std::string> ways = {
      "import random\nfirst = random.randrange(1000)\nturn = lambda robot: random.choice([-90, 0, 90])\n",
      "from random import choice\nturn = lambda robot: choice([-90, 0, 90])\n",
      "import random\nrandom.seed()\nturn = lambda robot: random.choice([-90, 0, 90])\n",
      "import random\ndice = random.Random()\nturn = lambda robot: dice.choice([-90, 0, 90])\n",
      "import random\ndice = random.SystemRandom()\nturn = lambda robot: dice.choice([-90, 0, 90])\n",
      "import random\ndef set_up(robot): robot.turns = [random.sample([-90, 0, 90], 1)[0] for _ in range(20)]\n"
      "turn = lambda robot: robot.turns.pop()\n",
      "import os\nturn = lambda robot: [-90, 0, 90][bytearray(os.urandom(1))[0] % 3]\n",
      "import random\nsides = list({'left', 'ahead', 'right'})\nrandom.shuffle(sides)\n"
      "turn = lambda robot: {'left': -90, 'ahead': 0, 'right': 90}[random.choice(sides)]\n",
      "turns = [ord(name[0]) % 3 * 90 - 90 for name in {'a%d' % n if n % 2 else 'b%d' % n for n in range(20)}]\n"
      "turn = lambda robot: turns.pop()\n",
      "turn = lambda robot: hash('a name' + str(robot.n)) % 3 * 90 - 90\n"};
  // Each takes a second or more: of many, the first, the middle and the last.
  for (std::size_t i = 0; i < ways.size(); i += test::thorough ? 1 : (ways.size() - 1) / 2) {
    SCOPED_TRACE(ways[i]);
    const std::string path = file("robot.py", robot_turning(ways[i]));
    expect_repeats([&](std::uint64_t seed) { return contest_of(path, 20, seed); });
  }
}

TEST_P(ARobot, ThrowsTheSameDiceOfAnOldNumpyThatAsksTheSystemItself) {
  std::filesystem::create_directories(folder_ / "numpy" / "random");
  file("numpy/__init__.py", "");
  file("numpy/random/__init__.py", test::unindented(R"(
    class RandomState(object):
        def __init__(self, seed=None):
            RandomState.seed(self, seed)
        def seed(self, seed=None):
            with open('/dev/urandom', 'rb') as system:
                self.state = sum(byte << 8 * n for n, byte in enumerate(bytearray(system.read(4)))) if seed is None else seed
        def turn(self):
            self.state = (self.state * 1103515245 + 12345) % 2 ** 31
            return self.state // 2 ** 16 % 3 * 90 - 90

    shared = RandomState()
    seed, turn = shared.seed, shared.turn
  )"));
  for (const char* way : {"from numpy.random import turn as throw\nturn = lambda robot: throw()\n",
                          "import numpy.random\ndice = numpy.random.RandomState()\nturn = lambda robot: dice.turn()\n",
                          "from numpy import random\nrandom.seed()\nturn = lambda robot: random.turn()\n",
                          "from numpy.random import RandomState\ndice = RandomState(5)\ndice.seed()\n"
                          "turn = lambda robot: dice.turn()\n"}) {
    SCOPED_TRACE(way);
    const std::string path = file("robot.py", robot_turning(way));
    expect_repeats([&](std::uint64_t seed) { return contest_of(path, 20, seed); });
  }
}

TEST_P(ARobotWithNumpy, ThrowsTheSameDiceInTheSameContest) {
  const std::vector<std::string> ways = {
      "import numpy as np\nturn = lambda robot: np.random.choice([-90, 0, 90])\n",
      "from numpy.random import randint\nturn = lambda robot: 90 * randint(-1, 2)\n",
      "import numpy\ndice = numpy.random.RandomState()\nturn = lambda robot: dice.choice([-90, 0, 90])\n",
      "import numpy as np\ndef set_up(robot): robot.dice = np.random.default_rng()\n"
      "turn = lambda robot: robot.dice.choice([-90, 0, 90])\n",
      "import random, numpy as np\nnp.random.seed()\nturn = lambda robot: np.random.permutation([-90, 0, 90])[0]\n",
      "import numpy as np\nturns = list({'left', 'ahead', 'right'}) * 7\nnp.random.shuffle(turns)\n"
      "turn = lambda robot: {'left': -90, 'ahead': 0, 'right': 90}[turns.pop()]\n"};
  // Each takes a second or more: of many, the first, the middle and the last.
  for (std::size_t i = 0; i < ways.size(); i += test::thorough ? 1 : (ways.size() - 1) / 2) {
    SCOPED_TRACE(ways[i]);
    const std::string path = file("robot.py", robot_turning(ways[i]));
    expect_repeats([&](std::uint64_t seed) { return contest_of(path, 20, seed); });
  }
}

TEST_P(ARobotWithNumpy, KeepsTheSeedThatItChose) {
  const std::string path = file("robot.py", robot_turning("import numpy as np\nnp.random.seed(5)\n"
                                                          "turn = lambda robot: np.random.choice([-90, 0, 90])\n"));
  EXPECT_EQ(contest_of(path, 20, 1).steps, contest_of(path, 20, 2).steps);
}

TEST_P(ARobotWithNumpy, LoadsItOnlyWhereItIsUsed) {
  const RunRecord record = contest_by("import random, sys\nreturn 90, 'numpy' in sys.modules", 1);
  EXPECT_THAT(actions(record), ElementsAre(step(90, 0)));
}

INSTANTIATE_TEST_SUITE_P(Python, ARobot, testing::Values("python3", "python2"),
                         [](const auto& python) { return std::string(python.param); });
INSTANTIATE_TEST_SUITE_P(Python, ARobotWithNumpy, testing::Values("numpy"));

}  // namespace
}  // namespace labmouse
