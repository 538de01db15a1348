// Sources whose bytes come as time passes.
#include "labmouse/lab/system/live_source.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;

constexpr int patience = 60'000;  // ms
constexpr int usual = 115'200;

/// The next bytes; empty at the end.
std::string next_of(LiveSource& source) {
  while (true) {
    const LiveSource::Piece piece = source.read(patience);
    EXPECT_EQ(piece.error, "");
    if (piece.ended || !piece.bytes.empty()) return piece.bytes;
  }
}

std::string all_of(OpenedSource& opened) {
  std::string all;
  for (std::string piece = next_of(*opened.source); !piece.empty(); piece = next_of(*opened.source)) all += piece;
  return all;
}

void write_all(int descriptor, const std::string& text) {
  ASSERT_EQ(write(descriptor, text.data(), text.size()), static_cast<ssize_t>(text.size()));
}

class ALiveSource : public testing::Test {
 protected:
  ALiveSource() { std::filesystem::create_directories(folder_); }
  ~ALiveSource() override { std::filesystem::remove_all(folder_); }
  std::string path(const std::string& name) const { return folder_ / name; }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("labmouse-live-" + std::to_string(getpid()));
};

TEST_F(ALiveSource, MayBeAFile) {
  const std::string text(10'000, 'x');
  std::ofstream(path("log.txt")) << text;
  OpenedSource opened = open_source(path("log.txt"), usual);
  ASSERT_TRUE(opened.source) << opened.error;
  EXPECT_EQ(all_of(opened), text);
  EXPECT_THAT(open_source(path("log.txt"), usual, LiveUse::read_and_answer).error, Says("answered", "tcp:HOST:PORT"));
}

TEST_F(ALiveSource, MayBeAPipeThatNobodyWritesYet) {
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  OpenedSource opened = open_source(path("pipe"), usual);
  ASSERT_TRUE(opened.source) << opened.error;
  EXPECT_FALSE(opened.source->read(0).ended);
  const int writer = open(path("pipe").c_str(), O_WRONLY | O_CLOEXEC);
  write_all(writer, "one");
  EXPECT_EQ(next_of(*opened.source), "one");
  EXPECT_EQ(opened.source->read(0).bytes, "");
  close(writer);
  EXPECT_TRUE(opened.source->read(patience).ended);
}

TEST_F(ALiveSource, MayBeATerminal) {
  const int robot = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (robot < 0 || grantpt(robot) != 0 || unlockpt(robot) != 0) GTEST_SKIP() << "this system lends no terminals";
  const std::string name = ptsname(robot);
  EXPECT_THAT(open_source(name, 12'345).error, Says("12345", "115200"));
  OpenedSource opened = open_source(name, 9600);
  ASSERT_TRUE(opened.source) << opened.error;
  termios settings{};
  ASSERT_EQ(tcgetattr(robot, &settings), 0);
  EXPECT_EQ(cfgetispeed(&settings), static_cast<speed_t>(B9600));
  // Nothing is echoed, changed or kept until the end of a line; these would end a program or a line.
  write_all(robot, "a\r\x03\x04\x11");
  EXPECT_EQ(next_of(*opened.source), "a\r\x03\x04\x11");
  OpenedSource answering = open_source(name, 9600, LiveUse::read_and_answer);
  ASSERT_TRUE(answering.source) << answering.error;
  answering.source->send("plan S2\n");
  answering.source->send(std::string(5000, 'x'));  // more than is kept
  answering.source->read(0);
  answering.source->read(0);
  std::array<char, 100> answer{};
  EXPECT_EQ(read(robot, answer.data(), answer.size()), 8);
  EXPECT_STREQ(answer.data(), "plan S2\n");
  answering.source.reset();
  close(robot);
  EXPECT_TRUE(opened.source->read(patience).ended);
}

TEST_F(ALiveSource, MayBeAConnection) {
  const int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* place = reinterpret_cast<sockaddr*>(&address);
  if (listener < 0 || bind(listener, place, size) != 0 || listen(listener, 1) != 0 ||
      getsockname(listener, place, &size) != 0)
    GTEST_SKIP() << "this system has no loopback";
  const std::string name = "tcp:127.0.0.1:" + std::to_string(ntohs(address.sin_port));
  OpenedSource opened = open_source(name, usual);
  ASSERT_TRUE(opened.source) << opened.error;
  const int robot = accept(listener, nullptr, nullptr);
  close(listener);
  EXPECT_EQ(opened.source->read(0).bytes, "");
  write_all(robot, "one");
  EXPECT_EQ(next_of(*opened.source), "one");
  close(robot);
  EXPECT_TRUE(opened.source->read(patience).ended);
  EXPECT_THAT(open_source(name, usual).error, Says("reached")) << "nobody listens";
}

TEST_F(ALiveSource, IsRefusedIfItIsNone) {
  EXPECT_THAT(open_source(path("none"), usual).error, Says("no such file"));
  for (const char* name :
       {"tcp:", "tcp:robot", "tcp:robot:", "tcp::23", "tcp:robot:0", "tcp:robot:65536", "tcp:robot:2x"})
    EXPECT_THAT(open_source(name, usual).error, Says("tcp:HOST:PORT")) << name;
  OpenedSource folder = open_source(path(""), usual);
  ASSERT_TRUE(folder.source);
  const LiveSource::Piece piece = folder.source->read(patience);
  EXPECT_TRUE(piece.ended);
  EXPECT_THAT(piece.error, Says("folder"));
}

}  // namespace
}  // namespace labmouse
