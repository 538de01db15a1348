#include "labmouse/lab/mice_files/mice_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/lab/mistake.hpp"

namespace labmouse {
namespace {

using test::Mistake;
using ::testing::ElementsAre;
using ::testing::SizeIs;
using namespace std::chrono_literals;

TEST(MiceFile, NamesMiceOfAllKinds) {
  const MiceFileResult read = read_mice_file(R"(
[[mouse]]
name = "Ours"
mouse = "flood:stride=1"

[[mouse]]
name = "Anna's"
capstone = "anna/robot.py"
arguments = ["ff", "no"]
environment = { MODE = "fast" }
interpreter = "python2"
runs = 3
note = "Anna, 2026"
limits = { start = 2, decision = 0.5, contest = 7, memory = 100, processes = 5, written = 16, cpu = 9 }

[[mouse]]
name = "Ben's"
mms = "./ben --quick"
directory = "ben"

[[mouse]]
name = "Cleo's"
pilot = "./cleo 8"
)");
  ASSERT_THAT(read.problems, SizeIs(0));
  ASSERT_THAT(read.mice, SizeIs(4));
  EXPECT_EQ(key_of(read.mice[3].kind), "controller");
  EXPECT_EQ(read.mice[3].what, "./cleo 8");
  EXPECT_EQ(key_of(read.mice[0].kind), "mouse");
  EXPECT_EQ(read.mice[0].what, "flood:stride=1");
  const MiceFileEntry& anna = read.mice[1];
  EXPECT_EQ(anna.name, "Anna's");
  EXPECT_EQ(key_of(anna.kind), "capstone");
  EXPECT_THAT(anna.arguments, ElementsAre("ff", "no"));
  EXPECT_THAT(anna.environment, ElementsAre("MODE=fast"));
  EXPECT_EQ(anna.interpreter, "python2");
  EXPECT_EQ(anna.runs, 3);
  EXPECT_EQ(anna.note, "Anna, 2026");
  EXPECT_EQ(anna.line, 6);
  EXPECT_EQ(read.mice[2].directory, "ben");
  const ExternalLimits limits = anna.limits.over({});
  EXPECT_EQ(limits.start, 2s);
  EXPECT_EQ(limits.decision, 500ms);
  EXPECT_EQ(limits.silence, ExternalLimits().silence);
  EXPECT_EQ(limits.contest, 7s);
  EXPECT_EQ(limits.memory, std::uint64_t{100} << 20U);
  EXPECT_EQ(limits.written, std::uint64_t{16} << 20U);
  EXPECT_EQ(limits.processes, 5);
  EXPECT_EQ(limits.processor_seconds, 9);
}

class MiceFileMistakes : public testing::TestWithParam<Mistake> {};

TEST_P(MiceFileMistakes, AreToldWhereTheyStand) {
  const MiceFileResult read = read_mice_file(GetParam().text);
  EXPECT_THAT(read.mice, SizeIs(0));
  test::expect_first(read.problems, GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    All, MiceFileMistakes,
    testing::Values(
        Mistake{"", 1, 1, {"[[mouse]]"}}, Mistake{"mouse = 3\n", 1, 1, {"[[mouse]]"}}, Mistake{"[[mouse]\n", 1, 9, {}},
        Mistake{"[[mice]]\nname = 'a'\n", 1, 3, {"'mice'"}}, Mistake{"[[mouse]]\nmouse = 'flood'\n", 1, 1, {"name"}},
        Mistake{"[[mouse]]\nname = 'a'\n", 1, 1, {"capstone"}},
        Mistake{"[[mouse]]\nname = 'a'\nmouse = 'flood'\nprogram = './a'\n", 4, 11, {"'mouse'"}},
        Mistake{"[[mouse]]\nname = 'a'\nmouse = 'flood'\n[[mouse]]\nname = 'a'\nmms = 'b'\n", 5, 8, {"'a'", "twice"}},
        Mistake{"[[mouse]]\nname = 'a'\nmouse = 'flood'\ndirectory = 'x'\n", 4, 13, {"'directory'", "external mice"}},
        Mistake{"[[mouse]]\nname = 'a'\ncapstone = 'a.py'\ndirectory = 'x'\n", 4, 13, {"'directory'", "robot"}},
        Mistake{"[[mouse]]\nname = 'a'\nprogram = 'x'\nargumets = []\n", 4, 1, {"'argumets'", "'arguments'"}},
        Mistake{"[[mouse]]\nname = 'a'\nprogram = 'x'\narguments = 'fast'\n", 4, 13, {"list"}},
        Mistake{"[[mouse]]\nname = 'a'\nprogram = 'x'\nenvironment = { A = 3 }\n", 4, 21, {"A"}},
        Mistake{"[[mouse]]\nname = 'a'\nprogram = 'x'\nruns = 0\n", 4, 8, {"1 to"}},
        Mistake{"[[mouse]]\nname = 'a'\nprogram = 'x'\nlimits = { contest = -1 }\n", 4, 22, {"seconds"}},
        Mistake{"[[mouse]]\nname = 'a'\nprogram = 'x'\nlimits = { memry = 20 }\n", 4, 12, {"'memory'"}},
        Mistake{"[[mouse]]\nname = \"a\\u001b\"\nprogram = 'x'\n", 2, 8, {"printable"}}),
    [](const auto& test) { return "mistake_" + std::to_string(test.index); });

TEST(MiceFile, TellsAllMistakesAtOnce) {
  EXPECT_THAT(read_mice_file("[[mouse]]\nnam = 'a'\n[[mouse]]\nname = ''\nmouse = 3\n").problems, SizeIs(5));
}

}  // namespace
}  // namespace labmouse
