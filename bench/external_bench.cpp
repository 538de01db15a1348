// Overhead of a mouse in another process, on one processor: our protocols compared with a bare ping-pong over pipes.
#include <benchmark/benchmark.h>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "bench_mazes.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/external/external_strategy.hpp"
#include "labmouse/external/mms/run.hpp"

namespace labmouse {
namespace {

/// Pins this thread and the processes that it starts to one processor, as in a race that uses all processors.
class OneProcessor {
 public:
  OneProcessor() {
    sched_getaffinity(0, sizeof before_, &before_);
    cpu_set_t one;
    CPU_ZERO(&one);
    int processor = 0;
    while (!CPU_ISSET(processor, &before_)) ++processor;
    CPU_SET(processor, &one);
    sched_setaffinity(0, sizeof one, &one);
  }
  OneProcessor(const OneProcessor&) = delete;
  OneProcessor& operator=(const OneProcessor&) = delete;
  ~OneProcessor() { sched_setaffinity(0, sizeof before_, &before_); }

 private:
  cpu_set_t before_{};
};

Launch bench_program(std::vector<std::string> words) {
  Launch launch;
  launch.words = std::move(words);
  launch.words.insert(launch.words.begin(), LABMOUSE_BENCH_PROGRAM);
  launch.limits.contest = std::chrono::hours(1);
  return launch;
}

/// A child process that is connected by two pipes.
class BareProgram {
 public:
  explicit BareProgram(const char* how, const char* times = nullptr) {
    std::array<int, 2> there{}, back{};
    if (pipe(there.data()) != 0 || pipe(back.data()) != 0) return;
    child_ = fork();
    if (child_ == 0) {
      dup2(there[0], STDIN_FILENO);
      dup2(back[1], STDOUT_FILENO);
      for (const int end : {there[0], there[1], back[0], back[1]}) close(end);
      execl(LABMOUSE_BENCH_PROGRAM, LABMOUSE_BENCH_PROGRAM, how, times, nullptr);
      _exit(127);
    }
    close(there[0]);
    close(back[1]);
    input_ = there[1];
    output_ = back[0];
  }
  BareProgram(const BareProgram&) = delete;
  BareProgram& operator=(const BareProgram&) = delete;
  ~BareProgram() {
    close(input_);
    close(output_);
    waitpid(child_, nullptr, 0);
  }

  bool say(std::string_view text) const { return write(input_, text.data(), text.size()) > 0; }
  /// Reads the available bytes; empty at the end of the stream.
  std::string_view hear() {
    const ssize_t count = read(output_, bytes_.data(), bytes_.size());
    return {bytes_.data(), count > 0 ? static_cast<std::size_t>(count) : 0};
  }

 private:
  pid_t child_ = -1;
  int input_ = -1, output_ = -1;
  std::array<char, 1U << 16U> bytes_{};
};

/// One line in each direction: the lower bound for any host.
void ping_pong_bare(benchmark::State& state) {
  const OneProcessor one;
  BareProgram external("echo");
  for (auto _ : state)
    if (!external.say("sense 0 11 0\n") || external.hear().empty()) return state.SkipWithError("the child is gone");
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(ping_pong_bare)->UseRealTime();

/// The same by ExternalStrategy and our line protocol.
void ping_pong_program(benchmark::State& state) {
  const OneProcessor one;
  const Maze maze = bench_mazes(16).front();
  ExternalStrategy strategy(bench_program({"guest"}), brief(maze, Rules(), 1));
  const Sighting seen = {0, 11, 0};
  for (auto _ : state)
    if (strategy.decide(seen).kind == Action::Kind::forfeit)
      return state.SkipWithError(std::string(strategy.report().last_words).c_str());
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(ping_pong_program)->UseRealTime();

/// Runs a program for mms from start to end; the items are the commands that it sends.
void host(benchmark::State& state, const char* how, int times, int commands) {
  const OneProcessor one;
  const Maze maze = bench_mazes(16).front();
  MmsOptions endless;
  endless.most_seconds = 1'000'000;
  for (auto _ : state) {
    const MmsRun run = run_mms(bench_program({how, std::to_string(times)}), maze, endless);
    if (run.lines != std::int64_t{times} * commands) return state.SkipWithError("commands were lost");
  }
  state.SetItemsProcessed(state.iterations() * times * commands);
}

void mms_ask_and_wait(benchmark::State& state) { host(state, "ask", 20'000, 1); }
BENCHMARK(mms_ask_and_wait)->UseRealTime();

void mms_bursts_of_4000(benchmark::State& state) { host(state, "burst", 50, 4000); }
BENCHMARK(mms_bursts_of_4000)->UseRealTime();

void mms_2800000_commands(benchmark::State& state) { host(state, "burst", 700, 4000); }
BENCHMARK(mms_2800000_commands)->UseRealTime()->Iterations(1);

constexpr int ahead = 500'000;

/// A program that writes single lines and reads no reply, into a pipe that is only drained: the lower bound for
/// mms_write_ahead.
void write_ahead_bare(benchmark::State& state) {
  const OneProcessor one;
  for (auto _ : state) {
    BareProgram external("ahead", std::to_string(ahead).c_str());
    std::int64_t lines = 0;
    for (std::string_view heard; !(heard = external.hear()).empty();)
      lines += std::count(heard.begin(), heard.end(), '\n');
    if (lines != ahead) return state.SkipWithError("commands were lost");
  }
  state.SetItemsProcessed(state.iterations() * ahead);
}
BENCHMARK(write_ahead_bare)->UseRealTime();

void mms_write_ahead(benchmark::State& state) { host(state, "ahead", ahead, 1); }
BENCHMARK(mms_write_ahead)->UseRealTime();

}  // namespace
}  // namespace labmouse
