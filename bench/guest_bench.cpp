// What it costs that a mouse is another program, on one processor: a bare ping-pong over pipes, and what we make of it.
#include <benchmark/benchmark.h>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

#include "bench_mazes.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/guests/guest_mind.hpp"
#include "labmouse/guests/mms/run.hpp"

namespace labmouse {
namespace {

/// Keeps this thread and the processes that it starts on one processor, as they are where others race beside them.
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

Launch bench_guest(std::vector<std::string> words) {
  Launch launch;
  launch.words = std::move(words);
  launch.words.insert(launch.words.begin(), LABMOUSE_BENCH_GUEST);
  launch.limits.contest = std::chrono::hours(1);
  return launch;
}

/// Two pipes, one line each way, nothing else: what no host can beat.
void ping_pong_bare(benchmark::State& state) {
  const OneProcessor one;
  std::array<int, 2> there{}, back{};
  if (pipe(there.data()) != 0 || pipe(back.data()) != 0) return state.SkipWithError("no pipes");
  const pid_t child = fork();
  if (child == 0) {
    dup2(there[0], STDIN_FILENO);
    dup2(back[1], STDOUT_FILENO);
    for (const int end : {there[0], there[1], back[0], back[1]}) close(end);
    execl(LABMOUSE_BENCH_GUEST, LABMOUSE_BENCH_GUEST, "echo", nullptr);
    _exit(127);
  }
  close(there[0]);
  close(back[1]);
  constexpr std::string_view question = "sense 0 11 0\n";
  std::array<char, 4096> answer{};
  for (auto _ : state)
    if (write(there[1], question.data(), question.size()) < 0 || read(back[0], answer.data(), answer.size()) <= 0)
      return state.SkipWithError("the child is gone");
  state.SetItemsProcessed(state.iterations());
  close(there[1]);
  close(back[0]);
  waitpid(child, nullptr, 0);
}
BENCHMARK(ping_pong_bare)->UseRealTime();

/// A guest of ours that is asked.
void ping_pong_guest(benchmark::State& state) {
  const OneProcessor one;
  const Maze maze = bench_mazes(16).front();
  GuestMind mind(bench_guest({"guest"}), brief(maze, Rules(), 1));
  const Sighting seen = {0, 11, 0};
  for (auto _ : state)
    if (mind.decide(seen).kind == Action::Kind::forfeit)
      return state.SkipWithError(std::string(mind.last_words()).c_str());
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(ping_pong_guest)->UseRealTime();

/// A program for mms from its start to its end, by the commands that it sends.
void host(benchmark::State& state, const char* how, int times, int commands) {
  const OneProcessor one;
  const Maze maze = bench_mazes(16).front();
  for (auto _ : state) {
    const MmsRun run = run_mms(bench_guest({how, std::to_string(times)}), maze, {});
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

}  // namespace
}  // namespace labmouse
