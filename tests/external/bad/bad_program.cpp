// An external mouse that misbehaves: bad_program HOW [TAG [MINE OTHERS]]. The tag makes it findable among all
// processes. `pilot HOW` is one that drives a mouse itself, `part HOW` the tracker of a controller.
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <string>
#include <vector>

namespace {

/// What it says where it behaves: its greeting, an answer, and the beginning of one; and the first word of questions.
struct Manners {
  std::string greeting = "labmouse 1", answer = "move 90 0", begun = "move 0", question = "sense";
} manners;

void say(const std::string& line) { std::cout << line << std::endl; }

/// Reads lines until one begins with that word; false at the end.
bool hear(const std::string& word) {
  for (std::string line; std::getline(std::cin, line);)
    if (line.rfind(word, 0) == 0) return true;
  return false;
}

void greet() {
  hear("begin");
  say(manners.greeting);
}

void wait_for(int milliseconds) { poll(nullptr, 0, milliseconds); }

void work(int milliseconds) {
  const auto end = std::clock() + std::clock_t{milliseconds} * (CLOCKS_PER_SEC / 1000);
  while (std::clock() < end) {
  }
}

[[noreturn]] void hang() {
  for (;;) wait_for(1'000'000);
}

/// Turns on the spot for as long as it is asked.
void turn() {
  greet();
  while (hear(manners.question)) say(manners.answer);
}

/// A child that left the session and all its signals, and never ends.
void leave_a_daemon() {
  if (fork() != 0) return;
  setsid();
  if (fork() != 0) _exit(0);
  for (int number = 1; number < NSIG; ++number) std::signal(number, SIG_IGN);
  hang();
}

/// In the state in which processes wait for a disk: until a child that shares its memory has ended.
[[noreturn]] void wait_like_for_a_disk() {
  if (vfork() == 0) hang();
  std::exit(0);
}

/// Memory that is for all of its processes, although it is alone.
void share_memory() {
  constexpr std::size_t size = std::size_t{1} << 29U;
  char* memory = static_cast<char*>(mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  for (std::size_t i = 0; i < size; i += 4096) memory[i] = 1;
  hang();
}

/// In portions of so many bytes, slowly enough for a busy machine to see it grow.
void eat_memory(std::size_t portion) {
  std::vector<char*> all;
  for (;; wait_for(10)) {
    all.push_back(new char[portion]);
    for (std::size_t i = 0; i < portion; i += 4096) all.back()[i] = 1;
  }
}

/// So many children that hold so much and do nothing.
void start_idlers(int count, std::size_t bytes) {
  for (int i = 0; i < count; ++i) {
    if (fork() != 0) continue;
    std::vector<char> held(bytes, 'x');
    hang();
  }
  hang();
}

/// Doubles again and again; with a session for each, where nobody ends them by their group.
void bomb(bool sessions) {
  for (;;)
    if (fork() == 0 && sessions) setsid();
}

/// Files of a MiB each, of which none stays.
void write_files() {
  const std::string content(std::size_t{1} << 20U, 'x');
  for (;;) {
    std::FILE* file = std::fopen("written.tmp", "w");
    if (file == nullptr) std::exit(4);
    std::fwrite(content.data(), 1, content.size(), file);
    std::fclose(file);
    std::remove("written.tmp");
  }
}

void misbehave(std::string how) {
  if (how.rfind("pilot ", 0) == 0) {
    how.erase(0, how.find(' ') + 1);
    manners = {"labmouse pilot 1", "drive 0 0", "drive 0", "sense"};
  }
  if (how.rfind("part ", 0) == 0) {
    how.erase(0, how.find(' ') + 1);
    manners = {"labmouse pilot 1 tracker", "drive 0 0", "drive 0", "follow"};
  }
  if (how == "turn") return turn();
  if (how == "hang at the start") hang();
  if (how == "end at the start") return;
  if (how == "work at the start") return work(100), turn();
  if (how == "wait for a disk") wait_like_for_a_disk();
  if (how == "wrong greeting") return say("hello");
  if (how == "marked greeting") return say("\xEF\xBB\xBF" + manners.greeting);
  if (how == "mms") return say("mazeWidth");
  if (how == "other version") return say("labmouse 2"), hang();
  if (how == "daemon at the start") return leave_a_daemon(), say("rubbish"), hang();
  greet();
  hear(manners.question);
  if (how == "give up") say("forfeit"), hang();
  if (how == "hang") hang();
  if (how == "hang within a line") std::cout << manners.begun << std::flush, hang();
  if (how == "write notes") do
      std::cerr << "a note\n", say(manners.answer);
    while (hear(manners.question));
  if (how == "slow") {
    do wait_for(20), say(manners.answer);
    while (hear(manners.question));
  }
  if (how == "late") work(500), say(manners.answer), hang();
  if (how == "work") work(1'000'000);
  if (how == "die") std::cerr << "one\ntwo\nthree: no way out\n", std::exit(3);
  if (how == "end") std::exit(0);
  if (how == "crash") std::cerr << "about to crash\n", std::signal(SIGSEGV, SIG_DFL), raise(SIGSEGV);
  if (how == "rubbish") say("what?"), hang();
  if (how == "bytes") std::cout << std::string("\x00\xff\x1b[2J\n", 7) << std::flush, hang();
  if (how == "many answers") say(manners.answer + "\n" + manners.answer), hang();
  if (how == "flood")
    for (;;) std::cout << manners.answer << "\n";
  if (how == "long line")
    for (;;) std::cout << "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa";
  if (how == "flood errors")
    for (;;) std::cerr << "the same error again and again\n";
  if (how == "errors beside") {
    for (int i = 0; i < 100'000; ++i) std::cerr << "a line that nobody asked for\n";
    say(manners.answer);
    turn();
  }
  if (how == "fork and leave") leave_a_daemon(), std::exit(0);
  if (how == "leave answering") {
    if (fork() != 0) _exit(0);
    do say(manners.answer);
    while (hear(manners.question));
    hang();
  }
  if (how == "close output") close(STDOUT_FILENO), hang();
  if (how == "close input") close(STDIN_FILENO), hang();
  if (how == "close all") close(STDIN_FILENO), close(STDOUT_FILENO), close(STDERR_FILENO), hang();
  if (how == "eat memory") eat_memory(std::size_t{1} << 24U);
  if (how == "ask for memory") eat_memory(std::size_t{1} << 30U);
  if (how == "share memory") share_memory();
  if (how == "idlers") start_idlers(80, 1);
  if (how == "big idlers") start_idlers(10, std::size_t{1} << 26U);
  if (how == "bomb") bomb(false);
  if (how == "bomb in sessions") bomb(true);
  if (how == "write files") write_files();
  if (how == "burn on") std::signal(SIGXCPU, SIG_IGN);
  if (how == "burn" || how == "burn on")
    for (volatile unsigned i = 0; i <= i;) {
    }
  if (how == "stop the keeper") kill(getppid(), SIGSTOP), say("what?"), hang();
  if (how == "kill the keeper") kill(getppid(), SIGKILL), hang();
}

/// Makes a file of its own, and plays on once another external mouse has made another.
void meet(const char* mine, const char* others) {
  std::fclose(std::fopen(mine, "w"));
  while (access(others, F_OK) != 0) wait_for(1);
  turn();
}

}  // namespace

int main(int count, char** words) {
  if (count == 5) return meet(words[3], words[4]), 0;
  if (count > 1) misbehave(words[1]);
}
