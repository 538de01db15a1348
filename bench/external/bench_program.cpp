// The external mice of external_bench.cpp, each as fast as possible: bench_program echo | guest | ask N | burst N |
// ahead N.
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <string>
#include <string_view>

namespace {

std::array<char, 1U << 16U> bytes;

/// Reads the available bytes; empty at the end of the stream.
std::string_view hear() {
  const ssize_t count = read(STDIN_FILENO, bytes.data(), bytes.size());
  return {bytes.data(), count > 0 ? static_cast<std::size_t>(count) : 0};
}

bool say(std::string_view text) {
  return write(STDOUT_FILENO, text.data(), text.size()) == static_cast<ssize_t>(text.size());
}

/// Answers each line with a move: the other side of the bare ping-pong.
void echo() {
  while (!hear().empty() && say("move 90 0\n")) {
  }
}

/// Our protocol: one answer to each question.
void play() {
  std::string briefing;
  while (briefing.find("begin\n") == std::string::npos) briefing += hear();
  if (!say("labmouse 1\n")) return;
  // The first question may have come with the briefing.
  if (briefing.find("sense") != std::string::npos && !say("move 90 0\n")) return;
  echo();
}

/// A mouse of mms that asks and waits.
void ask(int times) {
  while (times-- > 0 && say("wallFront\n") && !hear().empty()) {
  }
}

/// A mouse of mms that writes 4,000 commands at once and then reads the replies.
void burst(int bursts) {
  constexpr int lines = 4000;
  std::string commands;
  for (int i = 0; i < lines / 2; ++i) commands += "wallFront\nturnRight\n";
  while (bursts-- > 0 && say(commands)) {
    long replies = 0;
    while (replies < lines) {
      const std::string_view heard = hear();
      if (heard.empty()) return;
      for (const char letter : heard) replies += letter == '\n';
    }
  }
}

/// A mouse of mms that writes each command by itself, and reads no reply.
void write_ahead(int times) {
  constexpr std::array<std::string_view, 4> commands = {"moveForward\n", "turnRight\n", "wallFront\n",
                                                        "setColor 3 4 G\n"};
  for (int i = 0; i < times && say(commands[static_cast<unsigned>(i) % commands.size()]); ++i) {
  }
}

}  // namespace

int main(int count, char** words) {
  const std::string_view how = count > 1 ? words[1] : "";
  const int times = count > 2 ? std::stoi(words[2]) : 0;
  if (how == "echo") echo();
  if (how == "guest") play();
  if (how == "ask") ask(times);
  if (how == "burst") burst(times);
  if (how == "ahead") write_ahead(times);
}
