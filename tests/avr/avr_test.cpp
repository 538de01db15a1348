// Firmware for chips in the physical world: pins against readings, a drive, faults, and board files. The firmware is
// compiled by the avr-gcc of this machine.
#include <map>
#include <sstream>

#include "tests/cli/user.hpp"
#include "tests/interpreters.hpp"

namespace labmouse::test {
namespace {

using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr const char* long_corridor =
    "o---o\n|   |\no   o\n|   |\no   o\n|   |\no   o\n| G |\no   o\n|   |\no   o\n| S |\no---o\n";

/// A user who compiles firmware.
class AFirmware : public AUser {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(LABMOUSE_AVR)) GTEST_SKIP() << "labmouse-avr was not built: there is no libsimavr";
    if (first_that_runs({"avr-gcc"}, "--version").empty()) GTEST_SKIP() << "no avr-gcc is in PATH";
  }

  /// Compiles a file of tests/avr/firmware to an ELF file of that name.
  std::string compiled(const std::string& source, const std::string& name, const std::string& options = "") const {
    const std::string command = "avr-gcc -mmcu=atmega328p -DF_CPU=16000000UL -std=gnu99 -Os -Wall -Wextra -Werror " +
                                options + " '" LABMOUSE_SOURCE_DIR "/tests/avr/firmware/" + source + "' -o '" +
                                (folder_ / name).string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return name;
  }

  /// Asks labmouse-avr these questions: its answers and what it writes to standard error.
  Ended asked(const std::string& arguments, const std::string& questions) const {
    file("questions.txt", questions);
    const std::string command = "cd '" + folder_.string() + "' && '" LABMOUSE_AVR "' " + arguments +
                                " <questions.txt >answers.txt 2>errors.txt";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content("answers.txt"), content("errors.txt")};
  }

  /// The last line of a log: its columns by number.
  std::vector<double> last_line(const std::string& log) const {
    std::string line, last;
    for (std::istringstream lines(content(log)); std::getline(lines, line);) last = line;
    std::vector<double> numbers;
    std::istringstream fields(last);
    for (std::string field; std::getline(fields, field, ',');) numbers.push_back(field.empty() ? 0 : std::stod(field));
    return numbers;
  }
  static constexpr std::size_t true_y = 17;

  /// Writes the maze and its rules.
  void lay_out(int seconds = 10) const {
    file("corridor.txt", long_corridor);
    // It stands in the last cell until the time is over.
    std::string rules = content_of(LABMOUSE_SOURCE_DIR "/rules/all-japan.toml");
    const auto limit = rules.find("time_limit");
    rules.replace(limit, rules.find('\n', limit) - limit, "time_limit = " + std::to_string(seconds));
    file("rules.toml", rules);
  }

  Ended driven(const std::string& firmware, std::vector<std::string> more = {}) const {
    lay_out();
    more.insert(more.begin(), {"run", "firmware:" + firmware, "corridor.txt", "--world", "physical", "--robot",
                               "beginner", "--variation", "lab", "--rules", "rules.toml", "--log", "run.csv"});
    return labmouse(more);
  }
};

constexpr const char* briefing =
    "labmouse pilot 1\nsize 16 16\nsensors.count_bits 16\ninfrared 1\ninfrared 2\ninfrared 3\nbegin\n";

/// That many questions, in each of which the encoders have counted more. The counter of the right wheel wraps.
std::string questions(int ticks, int left, int right) {
  std::string text;
  for (int tick = 1; tick <= ticks; ++tick)
    text += "sense " + std::to_string(tick) + " " + std::to_string(tick * left) + " " +
            std::to_string(static_cast<std::int16_t>(32'760 + tick * right)) + " 0 0 0 500 1000 4000 7000\n";
  return text;
}

/// The last whole line that the probe wrote, as numbers: dark, lit, ahead, left, battery, button, counts.
std::vector<int> last_report(const std::string& text) {
  std::string line, last;
  for (std::istringstream lines(text.substr(0, text.rfind('\n'))); std::getline(lines, line);) last = line;
  std::istringstream fields(last);
  return {std::istream_iterator<int>(fields), {}};
}

TEST_F(AFirmware, ReadsItsPins) {
  compiled("probe.c", "probe.elf");
  // Of each sensor 20 counts are ambient light. 3.5 V and 3.226 V of 5 V. A reading beyond the range is cut.
  const Ended ended = asked("probe.elf", std::string(briefing) + questions(40, 3, -2));
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, testing::StartsWith("labmouse pilot 1\ndrive "));
  auto report = last_report(ended.err);
  ASSERT_EQ(report.size(), 8U) << ended.err;
  // It has counted up to the tick in which it read them.
  EXPECT_GE(report[6], 3 * 35);
  EXPECT_LE(report[6], 3 * 39);
  EXPECT_GE(-report[7], 2 * 35);
  EXPECT_LE(-report[7], 2 * 39);
  report.resize(6);
  EXPECT_THAT(report, ElementsAre(20, 160, 300, 1023, 716, 660));
}

TEST_F(AFirmware, CountsEachEdge) {
  compiled("probe.c", "probe.elf");
  // At rest after 50 ticks, so that nothing is left to count.
  std::string text = std::string(briefing) + questions(50, 17, 11);
  for (int tick = 51; tick < 60; ++tick)
    text += "sense " + std::to_string(tick) + " 850 " + std::to_string(static_cast<std::int16_t>(32'760 + 550)) +
            " 0 0 0 0 0 0 7000\n";
  const auto report = last_report(asked("probe.elf", text).err);
  ASSERT_EQ(report.size(), 8U);
  // The first question only says where the counters are.
  EXPECT_EQ(report[6], 17 * 49);
  EXPECT_EQ(report[7], 11 * 49);
}

TEST_F(AFirmware, CountsTwoChannelsByPinChanges) {
  compiled("probe.c", "probe.elf", "-DQUADRATURE");
  std::string board = content_of(LABMOUSE_SOURCE_DIR "/boards/ukmarsbot.toml");
  const std::string clock = "clock = \"D2\"                  # A xor B\nb = \"D4\"";
  ASSERT_THAT(board, HasSubstr(clock));
  board.replace(board.find(clock), clock.size(), "a = \"A3\"\nb = \"PC4\"");
  file("board.toml", board);
  std::string text = std::string(briefing) + questions(20, -4, 0);
  for (int tick = 21; tick < 30; ++tick) text += "sense " + std::to_string(tick) + " -80 32760 0 0 0 0 0 0 7000\n";
  const auto report = last_report(asked("probe.elf board.toml", text).err);
  ASSERT_EQ(report.size(), 8U);
  EXPECT_EQ(report[6], -4 * 19);
}

TEST_F(AFirmware, DrivesMotorsByPwmAndDirection) {
  compiled("probe.c", "probe.elf");
  const Ended ended = asked("probe.elf", std::string(briefing) + questions(40, 0, 0));
  // 64 and 128 of 255; 512 of 1024, and inverted 256 of it; full, and off.
  EXPECT_THAT(ended.out, ContainsRegex("(drive 8224 -16448\n)+(drive [0-9]+ -[0-9]+\n)?(drive 16384 -24575\n)+"
                                       "(drive [0-9]+ -?[0-9]+\n)?(drive 32767 0\n)+$"))
      << ended.out;
}

TEST_F(AFirmware, DrivesAMotorByTwoPwmPins) {
  compiled("probe.c", "probe.elf");
  file("board.toml",
       "[left]\npwm = \"D9\"\nback_pwm = \"D10\"\na = \"D2\"\nb = \"D4\"\n[right]\npwm = \"D5\"\nback_pwm = \"D6\"\n"
       "a = \"D3\"\nb = \"D5\"\n");
  // 64 less 128 of 255; D5 is no output, and D6 is high in the end.
  const Ended ended = asked("probe.elf board.toml", std::string(briefing) + questions(40, 0, 0));
  EXPECT_THAT(ended.out, testing::StartsWith("labmouse pilot 1\ndrive -8224 0\n"));
  EXPECT_THAT(ended.out, testing::EndsWith("drive 32767 -32767\n"));
}

TEST_F(AFirmware, SeesAHandBeforeASensor) {
  compiled("probe.c", "probe.elf");
  file("board.toml", content_of(LABMOUSE_SOURCE_DIR "/boards/ukmarsbot.toml") +
                         "\n[[press]]\npin = \"A1\"\npressed = 4000\nat = 20\nhold = 20\n");
  const Ended ended = asked("probe.elf board.toml", std::string(briefing) + questions(70, 0, 0));
  std::string line, seen;
  for (std::istringstream lines(ended.err); std::getline(lines, line);)
    if (const auto report = last_report(line + "\n"); report.size() == 8)
      seen += report[2] == 818 ? '1' : report[2] == 300 ? '0' : '?';
  EXPECT_THAT(seen, ContainsRegex("^0+1+0+$"));
}

TEST_F(AFirmware, SaysWordsByItsSignals) {
  compiled("probe.c", "probe.elf");
  file("board.toml", content_of(LABMOUSE_SOURCE_DIR "/boards/ukmarsbot.toml") + "\n[signals]\nfast = \"D6\"\n");
  const Ended ended = asked("probe.elf board.toml", std::string(briefing) + questions(40, 0, 0));
  EXPECT_THAT(ended.out, ContainsRegex("drive [^f]*fast 32767 0\ndrive 32767 0\n"));
  EXPECT_EQ(ended.out.find("fast"), ended.out.rfind("fast"));
}

TEST_F(AFirmware, HasAButton) {
  compiled("probe.c", "probe.elf");
  const Ended ended = asked("probe.elf", std::string(briefing) + questions(710, 0, 0));
  std::string line, pressed;
  for (std::istringstream lines(ended.err); std::getline(lines, line);)
    if (const auto report = last_report(line + "\n"); report.size() == 8) pressed += report[5] > 1000 ? '1' : '0';
  EXPECT_THAT(pressed, ContainsRegex("^0+1+0+$"));
}

TEST_F(AFirmware, IsResetWhenItWasCarried) {
  compiled("probe.c", "probe.elf");
  const std::string text = std::string(briefing) + questions(10, 2, 2) + "carried crash\n" + questions(10, 2, 2);
  const std::string boots = asked("probe.elf", text).err;
  EXPECT_NE(boots.find("B\n"), boots.rfind("B\n")) << boots;
  file("board.toml", content_of(LABMOUSE_SOURCE_DIR "/boards/ukmarsbot.toml") + "\n[signals]\ncarried = \"press\"\n");
  const std::string once = asked("probe.elf board.toml", text).err;
  EXPECT_EQ(once.find("B\n"), once.rfind("B\n")) << once;
}

TEST_F(AFirmware, DrivesDownACorridorAndStops) {
  compiled("corridor.c", "robot.elf", "-DCELLS=4");
  const Ended ended = driven("robot.elf", {"--record", "run.jsonl"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("gate to gate in run 1"));
  // Four cells from the middle of the first, within a fifth of a cell; and no touch of a wall.
  EXPECT_NEAR(last_line("run.csv")[true_y], 90 + 4 * 180, 36);
  EXPECT_NEAR(last_line("run.csv")[true_y - 1], 90, 10);
  const std::string log = content("run.csv");
  std::vector<bool> visited(6);
  std::string line;
  for (std::istringstream lines(log); std::getline(lines, line);) {
    std::istringstream fields(line);
    std::string field;
    for (std::size_t i = 0; i <= true_y; ++i) std::getline(fields, field, ',');
    if (field != "true_y") visited.at(static_cast<std::size_t>(std::stod(field) / 180)) = true;
  }
  EXPECT_THAT(visited, ElementsAre(true, true, true, true, true, false));
  // The same contest, bit by bit.
  EXPECT_EQ(driven("robot.elf").code, 0);
  EXPECT_EQ(content("run.csv"), log);
}

struct Fault {
  const char* kind;
  const char* words;
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.kind; }

class AFault : public AFirmware, public testing::WithParamInterface<Fault> {};

TEST_P(AFault, IsAForfeitWithTheProgramCounter) {
  compiled("corridor.c", "robot.elf", std::string("-DCELLS=1 -DFAULT=") + GetParam().kind);
  const Ended ended = driven("robot.elf");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("forfeit (gave up)"));
  EXPECT_THAT(ended.out, ContainsRegex("\\| done *\n"));  // what it wrote to its serial port
  EXPECT_THAT(ended.out, ContainsRegex(GetParam().words));
  EXPECT_GT(last_line("run.csv")[true_y], 200);
}

INSTANTIATE_TEST_SUITE_P(All, AFault,
                         testing::Values(Fault{"ILLEGAL", "illegal instruction at 0x0[0-9a-f]* in illegal_here"},
                                         Fault{"JUMP", "illegal instruction at 0x6000, which has no code"},
                                         Fault{"FAR", "jump .* at 0xe000, which has no code"},
                                         Fault{"SLEEP", "sleeps .* at 0x0[0-9a-f]* in "},
                                         Fault{"WRITE", "write .* at 0x0[0-9a-f]* in "}),
                         [](const auto& tested) { return std::string(tested.param.kind); });

TEST_F(AFirmware, IsNamedByAMiceFile) {
  compiled("corridor.c", "robot.elf");
  file("board.toml", content_of(LABMOUSE_SOURCE_DIR "/boards/ukmarsbot.toml"));
  file("mice.toml", "[[mouse]]\nname = \"mine\"\nfirmware = \"robot.elf\"\narguments = [\"board.toml\"]\n");
  lay_out();
  const auto race = AUser::race({"--mice-file", "mice.toml", "--mazes", "corridor.txt", "--robot", "beginner",
                                 "--rules", "rules.toml", "--runs", "1"});
  const auto& mouse = race.at("groups").at(0).at("mice").at(0);
  EXPECT_EQ(mouse.at("finished"), 1) << mouse;
}

/// A sketch of the templates as the firmware of a chip, compiled with the Arduino core.
class ASketch : public AFirmware {
 protected:
  static constexpr const char* core = "/usr/share/arduino/hardware/arduino/avr";

  void SetUp() override {
    AFirmware::SetUp();
    if (!std::filesystem::exists(core)) GTEST_SKIP() << "the Arduino core is not in " << core;
    const std::string templates = LABMOUSE_SOURCE_DIR "/templates/firmware-host/";
    const std::string command = "'" + templates + "build-avr' '" + templates + "wall_follower/wall_follower.ino' '" +
                                (folder_ / "sketch.elf").string() + "'";
    ASSERT_EQ(std::system(command.c_str()), 0);
  }
};

constexpr const char* small_maze =
    "o---o---o---o---o\n|           |   |\no   o---o   o   o\n|   |       |   |\no   o---o---o   o\n|       |     G "
    "|\no   o   o   o---o\n"
    "| S |           |\no---o---o---o---o\n";

TEST_F(ASketch, DrivesOnItsChipAsOnThisMachine) {
  lay_out(60);
  file("maze.txt", small_maze);
  const auto race = AUser::race({"--mice", "chip=firmware:sketch.elf", "--mice",
                                 "host=controller:" LABMOUSE_SKETCH_TEMPLATE, "--mazes", "maze.txt", "--robot",
                                 "beginner", "--rules", "rules.toml", "--variation", "lab", "--runs", "1"});
  std::map<std::string, double> scores;
  for (const auto& mouse : race.at("groups").at(0).at("mice")) {
    const auto& result = mouse.at("results").at(0);
    ASSERT_EQ(mouse.at("finished"), 1) << result;
    scores[mouse.at("name")] = result.at("score").at("value").get<double>() * 1e-6;
    // It has followed the wall to the goal and back to the start.
    EXPECT_EQ(result.at("done"), 1) << result;
    EXPECT_EQ(result.at("carried"), 0) << result;
  }
  ASSERT_EQ(scores.size(), 2U);
  EXPECT_GT(scores["chip"], 10);
  EXPECT_NEAR(scores["host"] / scores["chip"], 1, 0.02);
}

TEST_F(ASketch, KeepsItsEepromThroughAReset) {
  const std::string text = std::string(briefing) + questions(30, 0, 0) + "carried crash\n" + questions(30, 0, 0);
  EXPECT_THAT(asked("sketch.elf", text).err, ContainsRegex("start 0[^s]*start 1"));
}

TEST_F(AUser, HasASketchThatIsResetOnThisMachine) {
  file("questions.txt", std::string(briefing) + questions(30, 0, 0) + "carried crash\n" + questions(30, 0, 0) +
                            "carried wish\n" + questions(3, 0, 0));
  // Line by line, as labmouse asks: what is sent before a reset must not be lost with it.
  const std::string command =
      "cd '" + folder_.string() +
      "' && mkfifo to from && { '" LABMOUSE_SKETCH_TEMPLATE
      "' <to >from 2>errors.txt & } && exec 3>to 4<from && while read -r line; do echo \"$line\" >&3; case $line in "
      "sense*|begin) read -r answer <&4;; esac; done <questions.txt && exec 3>&- && wait";
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_THAT(content("errors.txt"), ContainsRegex("^start 0[^s]*start 1[^s]*start 2[^s]*$"));
}

TEST_F(AFirmware, HasAProblemOfItsBoardWithItsLine) {
  compiled("probe.c", "probe.elf");
  std::string board = content_of(LABMOUSE_SOURCE_DIR "/boards/ukmarsbot.toml");
  const auto at = board.find("pwm = \"D9\"");
  const auto line = 1 + std::count(board.begin(), board.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  board.replace(at, 10, "pwm = \"D8\"");
  file("board.toml", board);
  const Ended ended = asked("probe.elf board.toml", briefing);
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(ended.out, "");
  EXPECT_THAT(ended.err, HasSubstr("board.toml:" + std::to_string(line) + ":7: 'pwm'"));
}

struct BadBoard {
  const char *text, *where, *what;
};

TEST_F(AFirmware, RefusesBadBoards) {
  compiled("probe.c", "probe.elf");
  const std::string wheels =
      "[left]\npwm = \"D9\"\ndirection = \"D7\"\na = \"D2\"\nb = \"D4\"\n[right]\npwm = \"D10\"\ndirection = \"D8\"\na "
      "= "
      "\"D3\"\nb = \"D5\"\n";
  file("board.toml", wheels);
  EXPECT_EQ(asked("probe.elf board.toml", briefing).code, 0) << content("errors.txt");
  for (const BadBoard& bad : std::initializer_list<BadBoard>{
           {"[[press]]\npin = \"A6\"\n", "11:", "'at'"},
           {"[battery]\npin = \"D4\"\n", "12:", "ADC"},
           {"[signals]\ngoal = \"A7\"\n", "12:", "digital"},
           {"[signals]\ngaol = \"D6\"\n", "12:", "'goal'"},
           {"[[infrared]]\npin = \"A0\"\nambient = 2000\n", "13:", "1023"},
           {"[[infrared]]\npin = \"A9\"\n", "12:", "pin"},
       }) {
    file("board.toml", wheels + bad.text);
    const Ended ended = asked("probe.elf board.toml", briefing);
    EXPECT_EQ(ended.code, 1) << bad.text;
    EXPECT_THAT(ended.err, testing::AllOf(HasSubstr(std::string("board.toml:") + bad.where), HasSubstr(bad.what)));
  }
  file("board.toml", wheels + "[[infrared]]\npin = \"A0\"\n");
  EXPECT_EQ(asked("probe.elf board.toml", "labmouse pilot 1\nbegin\n").code, 1) << "a robot without its sensor";
}

TEST_F(AFirmware, MustBeAProgramForAvr) {
  file("robot.elf", "none");
  file("corridor.txt", long_corridor);
  for (const std::string& path : {std::string("robot.elf"), std::string(LABMOUSE_AVR)}) {
    const Ended ended = asked("'" + path + "'", briefing);
    EXPECT_EQ(ended.code, 1);
    EXPECT_EQ(ended.out, "");
    EXPECT_THAT(ended.err, HasSubstr("ELF"));
  }
  // Nor does a part of one do harm.
  const std::string whole = content(compiled("probe.c", "probe.elf"));
  for (std::size_t size = 0; size < whole.size(); size += whole.size() / 40) {
    file("part.elf", whole.substr(0, size));
    const int code = asked("part.elf", briefing).code;
    EXPECT_TRUE(code == 0 || code == 1) << size << ": " << code;
  }
  for (std::size_t at = 16; at < 180; ++at) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 0xA5);
    file("changed.elf", changed);
    const int code = asked("changed.elf", std::string(briefing) + questions(3, 1, 1)).code;
    EXPECT_TRUE(code == 0 || code == 1) << at << ": " << code;
  }
  is_refused({"run", "firmware:none.elf", "corridor.txt", "--world", "physical", "--robot", "kerise"}, "none.elf");
  is_refused(
      {"run", "firmware:robot.elf", "corridor.txt", "--world", "physical", "--board", "none", "--robot", "kerise"},
      "none", "ukmarsbot");
  is_refused({"run", "firmware:robot.elf", "corridor.txt", "--world", "steps"}, "physical");
}

}  // namespace
}  // namespace labmouse::test
