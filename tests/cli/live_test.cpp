// The map of a real robot: from files, and from a simulated robot behind a pseudo-terminal, with what goes wrong there.
#include <arpa/inet.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <termios.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "tests/cli/user.hpp"

namespace labmouse {
namespace {

using test::AUser;
using test::Ended;
using test::patiently;
using test::Program;
using test::Says;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST_F(AUser, SeesTheMapOfARobot) {
  file("robot.log",
       "start\n0 0 N 101 batt=7900\n0 1 N 110\n1 1 E 011\n1 1 E ?\x1b[2J\n1 1 S 1?1 state=\x7f\n1 1 S 11? v=3\nv=4\n");
  const Ended ended = labmouse({"live", "robot.log", "--size", "2x2"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.err, "");
  EXPECT_EQ(ended.out,
            "line 1: restart\n"
            "line 4: the wall north of (1,1) is open, but it is the border\n"
            "   o---o---o\n"
            " 1 | G  Gv |\n"
            "   o   o---o\n"
            " 0 |GS | G |\n"
            "   o---o---o\n"
            "     0   1\n"
            "4 of 4 inner walls seen from 3 cells; 0 contradictions, 1 restart; 8 lines, 2 of noise\n"
            "batt=7900 v=4\n");
}

TEST_F(AUser, SeesWhereTheMapOfARobotIsWrong) {
  file("true.hex", "93\nee\n");
  file("robot.log", "0 0 N 101\n0 1 N 111\n1 1 E 11?\n");
  const Ended ended = labmouse({"live", "robot.log", "--against", "true.hex", "--save", "map.txt"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("line 2: false wall: the wall east of (0,1)"));
  EXPECT_EQ(content("map.txt"), "o---o---o\n| G | G |\no   o...o\n| G | G |\no---o---o\n");
  EXPECT_THAT(labmouse({"inspect", "map.txt", "--against", "true.hex"}).out, Says("2 right", "1 wrong", "1 unseen"));
  EXPECT_THAT(labmouse({"show", "map.txt"}).out, HasSubstr("o- -o"));
  // It replaces its own file, and no other one.
  EXPECT_EQ(labmouse({"live", "robot.log", "--size", "2x2", "--save", "map.txt"}).code, 0);
  file("notes.txt", "Buy tyres.\n");
  is_refused({"live", "robot.log", "--save", "notes.txt"}, "notes.txt", "--save");
}

TEST_F(AUser, IsToldWhyARobotCannotBeHeard) {
  is_refused({"live", "none"}, "none", "no such file");
  is_refused({"live", "tcp:robot"}, "tcp:robot", "tcp:HOST:PORT");
  is_refused({"live", "-", "--size", "0x3"}, "0x3");
  is_refused({"live", "-", "--size", "8x8", "--against", "contest-01"}, "--size");
  is_refused({"live", "-", "--plan"}, "--robot");
  is_refused({"live", "-", "--robot", "classic", "--plan"}, "tcp:HOST:PORT");
  is_refused({"live", "-", "--robot", "classic", "--size", "33x33"}, "--robot", "32x32");
  is_refused({"live", "-", "--start", "1,1"}, "--against");
  is_refused({"live", "-", "--baud", "0"}, "--baud");
}

constexpr std::string_view corners =
    "o---o---o---o---o\n"
    "|           |   |\n"
    "o   o---o   o   o\n"
    "|   |   |       |\n"
    "o   o   o---o   o\n"
    "| S |           |\n"
    "o---o---o---o---o\n";

/// The walls of a cell in that drawing, from the north clockwise.
std::string walls_of(int x, int y) {
  const int row = 5 - 2 * y, column = 4 * x + 2, width = 18;
  std::string walls;
  for (const int place :
       {(row - 1) * width + column, row * width + column + 2, (row + 1) * width + column, row * width + column - 2})
    walls += corners[static_cast<std::size_t>(place)] == ' ' ? '0' : '1';
  return walls;
}

std::string with_checksum(const std::string& line) {
  unsigned sum = ' ';
  for (const char letter : line) sum ^= static_cast<unsigned char>(letter);
  constexpr std::string_view digits = "0123456789abcdef";
  return line + " *" + digits[sum >> 4U] + digits[sum & 15U] + "\n";
}

/// What a robot sends that drives through all cells again and again: some lines are lost or cut by a reset, and bytes
/// are damaged or come from nowhere.
std::string troubled_stream() {
  std::string stream;
  for (int i = 0; i < 60; ++i) {
    const int y = i / 4 % 3, x = y % 2 == 0 ? i % 4 : 3 - i % 4;
    const std::string line = with_checksum(std::to_string(x) + " " + std::to_string(y) + " N " + walls_of(x, y));
    if (i % 7 == 3) continue;
    if (i % 9 == 1) stream += std::string("\xff\0\x1b[2J\x03\x04~", 9);
    if (i % 9 == 5) stream += "\r\n\x11\x13\n";
    if (i % 13 == 6) stream += line.substr(0, line.size() / 2) + "\n" + with_checksum("start");
    stream += line;
    if (i % 10 == 8) stream[stream.size() - 6] ^= 1;
  }
  return stream + with_checksum("start state=end");
}

/// A robot on a serial line: this side of a pseudo-terminal.
class ARealRobot : public AUser {
 protected:
  void SetUp() override {
    if (robot_ < 0 || grantpt(robot_) != 0 || unlockpt(robot_) != 0) GTEST_SKIP() << "this system lends no terminals";
    file("true.txt", std::string(corners));
  }
  ~ARealRobot() override { hang_up(); }

  void hang_up() {
    if (robot_ >= 0) close(robot_);
    robot_ = -1;
  }
  /// Sends the stream once the program has set up its side, and waits until its last line is read.
  void send(const std::string& stream) const {
    ASSERT_TRUE(patiently([&] {
      termios settings{};
      return tcgetattr(robot_, &settings) == 0 && (settings.c_lflag & ICANON) == 0;
    }));
    ASSERT_EQ(write(robot_, stream.data(), stream.size()), static_cast<ssize_t>(stream.size()));
    const auto lines = std::count(stream.begin(), stream.end(), '\n');
    const std::string last = "line " + std::to_string(lines) + ": restart\n";
    ASSERT_TRUE(patiently([&] { return content(".out").find(last) != std::string::npos; })) << content(".out");
  }
  void expect_the_whole_map(const Ended& ended) const {
    EXPECT_THAT(ended.out, Not(testing::AnyOf(HasSubstr("but open"), HasSubstr("but closed"), HasSubstr("\x1b"))));
    EXPECT_THAT(ended.out, HasSubstr("17 of 17 inner walls seen from 12 cells; 0 contradictions, 7 restarts"));
    EXPECT_THAT(labmouse({"inspect", "map.txt", "--against", "true.txt"}).out, Says("17 right", "0 wrong", "0 unseen"));
  }

  int robot_ = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  std::vector<std::string> words_ = {"live",   robot_ < 0 ? "" : ptsname(robot_), "--against", "true.txt", "--save",
                                     "map.txt"};
};

TEST_F(ARealRobot, IsHeardUntilItHangsUp) {
  const Program program(folder_, words_);
  send(troubled_stream());
  hang_up();
  const Ended ended = program.wait();
  EXPECT_EQ(ended.code, 0) << ended.err;
  expect_the_whole_map(ended);
}

TEST_F(ARealRobot, IsToldTheRouteThatItKnows) {
  words_.insert(words_.end(), {"--robot", "classic", "--plan"});
  const Program program(folder_, words_);
  send(troubled_stream());
  std::string told;
  ASSERT_TRUE(patiently([&] {
    std::array<char, 256> bytes{};
    pollfd waiting{robot_, POLLIN, 0};
    if (poll(&waiting, 1, 0) == 1) told.append(bytes.data(), static_cast<std::size_t>(read(robot_, bytes.data(), 256)));
    return told.find('\n') != std::string::npos;
  }));
  hang_up();
  const Ended ended = program.wait();
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(told, testing::StartsWith("plan S"));
  EXPECT_THAT(ended.out, HasSubstr("the known route takes "));
  expect_the_whole_map(ended);
}

TEST_F(ARealRobot, IsHeardUntilTheUserHasEnough) {
  const Program program(folder_, words_);
  send(troubled_stream());
  program.interrupt();
  const Ended ended = program.wait();
  EXPECT_EQ(ended.code, 128 + SIGINT) << ended.err;
  expect_the_whole_map(ended);
}

/// What a server on this computer answers to a request.
std::string fetched(const std::string& port, const std::string& path) {
  const int client = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(std::stoi(port)));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  std::string answer, request = "GET " + path + " HTTP/1.1\r\nHost: 127.0.0.1:" + port + "\r\n\r\n";
  if (connect(client, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0 &&
      write(client, request.data(), request.size()) == static_cast<ssize_t>(request.size())) {
    std::array<char, 4096> bytes{};
    for (ssize_t count = 1; count > 0;) {
      count = read(client, bytes.data(), bytes.size());
      if (count > 0) answer.append(bytes.data(), static_cast<std::size_t>(count));
    }
  }
  close(client);
  return answer;
}

TEST_F(AUser, ServesThePageWithTheLinesOfARobot) {
  const std::string page =
      file("page.html", "<head><meta content=\"connect-src ws://127.0.0.1:*\" /></head><!-- labmouse:report -->\n");
  file("robot.log", "0 0 N 101\n0 1 N 11");
  const Program program(folder_, {"live", "robot.log", "--size", "3x2", "--robot", "classic", "--page", page});
  const std::string begin = "Open http://127.0.0.1:";
  ASSERT_TRUE(patiently([&] { return content(".err").find("#live") != std::string::npos; }));
  const std::string link = content(".err").substr(begin.size());
  const std::string port = link.substr(0, link.find('/'));
  const std::string folder = link.substr(port.size(), link.find('#') - port.size());
  EXPECT_EQ(folder.size(), 34U);
  EXPECT_THAT(fetched(port, folder), HasSubstr("connect-src http://127.0.0.1:" + port + folder));
  EXPECT_THAT(fetched(port, folder + "begin"), testing::EndsWith(R"({"width":3,"height":2,"robot":"classic"})"));
  EXPECT_THAT(fetched(port, folder + "lines"), testing::EndsWith("\r\n\r\n0 0 N 101\n0 1 N 11\n"));
  EXPECT_THAT(fetched(port, "/"), Not(HasSubstr("robot")));
  program.interrupt();
  EXPECT_EQ(program.wait().code, 128 + SIGINT);
  is_refused({"live", "robot.log", "--page", "robot.log"}, "robot.log");
  is_refused({"live", "robot.log", "--host", "127.0.0.1"}, "--page");
  is_refused({"live", "robot.log", "--page", page, "--host", "0.0.0.0"}, "--host", "0.0.0.0");
}

TEST_F(AUser, HearsAnHourWithoutGrowthOfMemory) {
  const std::string page = file("page.html", "<head>connect-src ws://127.0.0.1:*</head><!-- labmouse:report -->\n");
  const auto memory_after = [&](int lines) {
    std::string log;
    for (int i = 0; i < lines; ++i)
      log += std::to_string(i % 16) + " " + std::to_string(i / 16 % 16) + " N 1??0 batt=7900 v=3\n";
    file("robot.log", log);
    const Program program(folder_, {"live", "robot.log", "--page", page});
    EXPECT_TRUE(patiently([&] { return content(".out").find(std::to_string(lines) + " lines") != std::string::npos; }));
    const long memory = program.most_memory();
    program.interrupt();
    EXPECT_EQ(program.wait().code, 128 + SIGINT);
    return memory;
  };
  // The server keeps 4 MiB of the lines; a string that grows takes twice that.
  constexpr long kept = 3 * 4096;  // kB
  EXPECT_LE(memory_after(720'000), memory_after(1000) + kept);
}

TEST_F(AUser, SeesTheMapGrowOnATerminal) {
  const std::string log = folder_ / file("robot.log", "0 0 N 101\n0 1 N 110 route=E\n0 1 N 111\n");
  const auto printed = test::on_a_terminal({"live", log, "--size", "3x2"}, "NO_COLOR=1");
  if (!printed) GTEST_SKIP() << "this system lends no terminals";
  EXPECT_THAT(*printed, AllOf(HasSubstr("\x1b[H"), HasSubstr("o   o- -o- -o"),
                              HasSubstr("line 3: the wall east of (0,1) is closed, but open in line 2")));
  const auto refused = test::on_a_terminal({"live", log}, "NO_COLOR=1");
  EXPECT_THAT(*refused, Says("16x16", "80x24"));
}

}  // namespace
}  // namespace labmouse
