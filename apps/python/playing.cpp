#include "playing.hpp"

#include <fmt/format.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <chrono>
#include <cstring>
#include <future>
#include <mutex>
#include <thread>
#include <tuple>
#include <utility>

#include "bindings.hpp"
#include "errors.hpp"
#include "interrupting.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/mazes/maze_link.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace labmouse::python {
namespace {

using Clock = std::chrono::steady_clock;

PackedAction packed(const Action& action) {
  return {static_cast<std::int32_t>(action.kind), action.rotation, action.movement,
          static_cast<std::int32_t>(action.reason)};
}

/// Writes down what a mouse does.
class WatchedMind final : public Strategy {
 public:
  WatchedMind(std::unique_ptr<Strategy> mouse, Playing& playing) : mouse_(std::move(mouse)), playing_(playing) {}
  WatchedMind(const WatchedMind&) = delete;
  WatchedMind& operator=(const WatchedMind&) = delete;
  ~WatchedMind() override { playing_.end(std::string(mouse_->last_words()), mouse_->started()); }

  Action decide(const Sighting& seen) override {
    const auto begin = Clock::now();
    const Action action = mouse_->decide(seen);
    playing_.add(action, std::chrono::duration<double, std::micro>(Clock::now() - begin).count());
    return action;
  }
  const Knowledge& knowledge() const override { return mouse_->knowledge(); }
  std::string_view last_words() override { return mouse_->last_words(); }

 private:
  std::unique_ptr<Strategy> mouse_;
  Playing& playing_;
};

class PlayedMind final : public Strategy {
 public:
  PlayedMind(Size size, Played played) : knowledge_(size), played_(std::move(played)) {}

  Action decide(const Sighting&) override {
    if (next_ >= played_.actions.size()) return Action::forfeit(ForfeitReason::interrupted);
    const PackedAction& action = played_.actions[next_++];
    return {static_cast<Action::Kind>(action[0]), action[1], action[2], static_cast<ForfeitReason>(action[3])};
  }
  const Knowledge& knowledge() const override { return knowledge_; }
  bool started() const override { return played_.started; }
  std::string_view last_words() override { return played_.last_words; }

 private:
  Knowledge knowledge_;
  Played played_;
  std::size_t next_ = 0;
};

Maze maze_of(const std::string& link) {
  ReadLinkResult read = read_link(link);
  if (!read.maze) throw UserError(read.error);
  return std::move(read.maze->maze);
}

std::shared_ptr<const MouseMaker> made_here(nb::object maker) {
  return std::make_shared<const MouseMaker>(std::move(maker), nb::none());
}

/// As a process tells it to another.
std::tuple<nb::bytes, std::string, bool, double> told(const Played& played) {
  return {nb::bytes(played.actions.data(), played.actions.size() * sizeof(PackedAction)), played.last_words,
          played.started, played.microseconds};
}

}  // namespace

Played death(std::string words) { return {{packed(Action::forfeit(ForfeitReason::died))}, std::move(words)}; }

void Playing::add(const Action& action, double microseconds) {
  const std::lock_guard lock(mutex_);
  played_.actions.push_back(packed(action));
  played_.microseconds += microseconds;
}

void Playing::end(std::string last_words, bool started) {
  const std::lock_guard lock(mutex_);
  played_.last_words = std::move(last_words);
  played_.started = started;
}

void Playing::keep(RunRecord record) {
  const std::lock_guard lock(mutex_);
  played_.record = std::move(record);
}

Played Playing::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(played_, {});
}

RunRecord play_in_steps(const std::shared_ptr<const MouseMaker>& maker, const Maze& maze, const Rules& rules,
                        std::uint64_t seed, Playing& playing) {
  WatchedMind mind(make_python_mind(maker, brief(maze, rules, seed), &playing.stopped()), playing);
  return run(maze, rules, mind);
}

Played play_apart(std::function<void(Playing&)> play, const std::atomic<bool>* stop) {
  struct Seat {
    Playing playing;
    std::atomic<unsigned long> thread{0};
  };
  const auto seat = std::make_shared<Seat>();
  std::packaged_task<void()> task([seat, play = std::move(play)] {
    seat->thread = PyThread_get_thread_ident();
    play(seat->playing);
  });
  std::future<void> end = task.get_future();
  std::thread thread(std::move(task));
  const auto has_ended = [&] { return end.wait_for(glance) == std::future_status::ready; };
  bool ended = false;
  while (!(ended = has_ended()) && (stop == nullptr || !stop->load())) {
  }
  if (!ended) seat->playing.stop();
  for (int told = 0; !ended && told < times_told; ++told) {
    interrupt(seat->thread);
    ended = has_ended();
  }
  if (ended) {
    thread.join();
    end.get();
  } else {
    thread.detach();
  }
  return seat->playing.take();
}

std::unique_ptr<Strategy> make_played_mind(Size size, Played played) {
  return std::make_unique<PlayedMind>(size, std::move(played));
}

void bind_minds(nb::module_& module) {
  module.def(
      "play",
      [](nb::object maker, const std::string& link, int budget, int stride, std::uint64_t seed) {
        Rules rules;
        rules.budget = budget;
        rules.stride = stride;
        Playing playing;
        play_in_steps(made_here(std::move(maker)), maze_of(link), rules, seed, playing);
        return told(playing.take());
      },
      "maker"_a, "link"_a, "budget"_a, "stride"_a, "seed"_a,
      "Plays a contest in steps for another process: the actions, the last words, whether the mouse started, and the "
      "microseconds that its decisions took.");
  module.def(
      "death", [](std::string words) { return told(death(std::move(words))); }, "words"_a,
      "What a mouse did whose process died.");
}

}  // namespace labmouse::python
