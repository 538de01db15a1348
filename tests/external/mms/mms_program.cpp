// A program for mms that does what its words say, in their order:
//
//   ask:LINE     writes the line and reads one reply          errors:TEXT   writes a line to standard error
//   say:LINE     writes the line                              part:TEXT     writes text without a line's end
//   hear:N       reads N replies, or complains and ends       exit:CODE, signal:NUMBER
//   burst:N:LINE writes the line N times, in large portions   hang, work, close, leave
//   trickle:N:LINE  the same, each by itself                  deafen        closes its standard input
//   ask-on:LINE/LINE  asks them for ever                         pour:LINE     writes the line for ever, and reads
//   nothing drip         writes a byte of no line now and then        need:REPLY    ends with code 8 unless the last
//   reply was it
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>

namespace {

std::string last_reply;

void hear(long count) {
  for (; count > 0; --count)
    if (!std::getline(std::cin, last_reply)) std::cerr << "no reply\n", std::exit(9);
}

void say(const std::string& line) { std::cout << line << std::endl; }

void ask(const std::string& line) {
  say(line);
  hear(1);
}

void burst(long count, const std::string& line) {
  std::string all;
  for (; count > 0; --count) all += line + '\n';
  std::cout << all << std::flush;
}

void trickle(long count, const std::string& line) {
  for (; count > 0; --count) say(line);
}

[[noreturn]] void ask_on(std::string lines) {
  std::replace(lines.begin(), lines.end(), '/', '\n');
  for (;;) {
    std::istringstream round(lines);
    for (std::string line; std::getline(round, line);) ask(line);
  }
}

[[noreturn]] void work() {
  for (volatile unsigned turns = 0;;) turns = turns + 1;
}

[[noreturn]] void hang() {
  for (;;) pause();
}

[[noreturn]] void drip() {
  for (;;) {
    std::cout << 'x' << std::flush;
    poll(nullptr, 0, 10);
  }
}

[[noreturn]] void leave() {
  if (fork() != 0) _exit(0);
  hang();
}

void obey(const std::string& word) {
  const auto colon = word.find(':');
  const std::string verb = word.substr(0, colon), rest = colon == std::string::npos ? "" : word.substr(colon + 1);
  if (verb == "ask") ask(rest);
  if (verb == "say") say(rest);
  if (verb == "hear") hear(std::stol(rest));
  if (verb == "need" && last_reply != rest) std::exit(8);
  if (verb == "burst") burst(std::stol(rest), rest.substr(rest.find(':') + 1));
  if (verb == "trickle") trickle(std::stol(rest), rest.substr(rest.find(':') + 1));
  if (verb == "part") std::cout << rest << std::flush;
  if (verb == "errors") std::cerr << rest << '\n';
  if (verb == "exit") std::exit(std::stoi(rest));
  if (verb == "signal") std::signal(std::stoi(rest), SIG_DFL), std::raise(std::stoi(rest));
  if (verb == "close") close(STDOUT_FILENO);
  if (verb == "deafen") close(STDIN_FILENO);
  if (verb == "work") work();
  if (verb == "hang") hang();
  if (verb == "leave") leave();
  if (verb == "drip") drip();
  if (verb == "ask-on") ask_on(rest);
  if (verb == "pour")
    for (;;) std::cout << rest << '\n';
}

}  // namespace

int main(int count, char** words) {
  for (int i = 1; i < count; ++i) obey(words[i]);
}
