#include "live_strategy.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <tuple>
#include <utility>

#include "bindings.hpp"
#include "briefing.hpp"
#include "interrupting.hpp"
#include "labmouse/mouse/knowledge.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace labmouse::python {
namespace {

/// Kind, rotation, movement and reason.
using ActionFields = std::tuple<int, int, int, int>;

ActionFields fields_of(const Action& action) {
  return {static_cast<int>(action.kind), action.rotation, action.movement, static_cast<int>(action.reason)};
}

Action action_of(const ActionFields& fields) {
  const auto& [kind, rotation, movement, reason] = fields;
  return {static_cast<Action::Kind>(kind), rotation, movement, static_cast<ForfeitReason>(reason)};
}

/// Passes calls from the contest to the thread of a mouse, one at a time, and waits for each.
class Desk {
 public:
  /// For the contest: has the thread call `deed`, and waits for its end. False if `stop` became true first.
  bool have_done(std::function<void()> deed, const std::atomic<bool>* stop) {
    std::unique_lock lock(mutex_);
    deed_ = std::move(deed);
    changed_.notify_all();
    while (deed_)
      if (changed_.wait_for(lock, glance) == std::cv_status::timeout && stop != nullptr && stop->load()) return !deed_;
    return true;
  }
  /// For the contest: waits for `glance` at most; whether the thread is idle then.
  bool comes_to_an_end() {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, glance, [this] { return !deed_; });
  }
  void close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    changed_.notify_all();
  }

  /// For the thread: makes the calls until close().
  void serve() {
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] { return deed_ || closed_; });
      if (!deed_) return;
      const std::function<void()> deed = deed_;
      lock.unlock();
      deed();
      lock.lock();
      deed_ = nullptr;
      changed_.notify_all();
    }
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::function<void()> deed_;
  bool closed_ = false;
};

/// A mouse in a thread of this process. The thread shares ownership of its Seat, because the contest may end first and
/// abandon a thread that never answers.
class ThreadStrategy final : public DrivingStrategy {
 public:
  ThreadStrategy(const std::shared_ptr<const MouseMaker>& maker, const Briefing& briefing,
                 const std::atomic<bool>* stop)
      : knowledge_(briefing.size), stop_(stop), seat_(std::make_shared<Seat>()) {
    thread_ = std::thread([seat = seat_] {
      seat->thread = PyThread_get_thread_ident();
      seat->desk.serve();
      seat->end();
    });
    have_done([maker, briefing](Seat& seat) {
      seat.mouse = make_python_strategy(maker, briefing, &seat.stopped);
      seat.started = seat.mouse->report().started;
      seat.idle = std::make_unique<nb::gil_scoped_release>();
    });
  }
  ThreadStrategy(const ThreadStrategy&) = delete;
  ThreadStrategy& operator=(const ThreadStrategy&) = delete;
  ~ThreadStrategy() override {
    seat_->is_left = is_left_;
    seat_->desk.close();
    if (is_left_)
      thread_.detach();
    else
      thread_.join();
  }

  Action decide(const Sighting& seen) override {
    ask([seen](Seat& seat) { seat.action = seat.mouse->decide(seen); });
    return is_left_ ? Action::forfeit(ForfeitReason::interrupted) : seat_->action;
  }
  Action consider(const LogOddsMap& map, const SearchPlace& place, std::int64_t) override {
    return decide(map.sighting(place.pose));
  }
  void show(const Pose& pose, const Sighting& seen) override {
    ask([=](Seat& seat) { seat.mouse->show(pose, seen); });
  }
  void carried(std::int64_t time) override {
    ask([=](Seat& seat) { seat.mouse->carried(time); });
  }
  const Knowledge& knowledge() const override { return knowledge_; }
  StrategyReport report() override {
    ask([](Seat& seat) {
      const StrategyReport report = seat.mouse->report();
      seat.words = report.last_words;
      seat.microseconds = report.microseconds;
    });
    if (is_left_) return {};
    return {.last_words = seat_->words, .microseconds = seat_->microseconds, .started = seat_->started};
  }

 private:
  struct Seat {
    Desk desk;
    std::atomic<unsigned long> thread{0};
    std::atomic<bool> stopped{false}, is_left{false};
    // Only the thread uses `mouse` and `idle`. The mouse holds the GIL, and `idle` releases it between calls. The
    // contest reads the other members after a call.
    std::unique_ptr<DrivingStrategy> mouse;
    std::unique_ptr<nb::gil_scoped_release> idle;
    bool started = true;
    Action action;
    std::string words;
    std::optional<double> microseconds;

    /// Leaks the mouse of an abandoned thread on purpose: the interpreter may already be shutting down.
    void end() {
      if (is_left) {
        static_cast<void>(idle.release());
        static_cast<void>(mouse.release());
        return;
      }
      idle.reset();
      mouse.reset();
    }
  };

  void ask(const std::function<void(Seat&)>& question) {
    have_done([question](Seat& seat) {
      seat.idle.reset();
      question(seat);
      seat.idle = std::make_unique<nb::gil_scoped_release>();
    });
  }

  void have_done(const std::function<void(Seat&)>& deed) {
    if (is_left_) return;
    if (seat_->desk.have_done([seat = seat_.get(), deed] { deed(*seat); }, stop_)) return;
    seat_->stopped = true;
    is_left_ = true;
    for (int told = 0; is_left_ && told < times_told; ++told) {
      interrupt(seat_->thread);
      is_left_ = !seat_->desk.comes_to_an_end();
    }
  }

  Knowledge knowledge_;
  const std::atomic<bool>* stop_;
  std::shared_ptr<Seat> seat_;
  bool is_left_ = false;
  std::thread thread_;
};

/// A mouse in another process.
class ProcessStrategy final : public DrivingStrategy {
 public:
  ProcessStrategy(const std::shared_ptr<const MouseMaker>& maker, const Briefing& briefing)
      : maker_(maker), knowledge_(briefing.size) {
    call([&] {
      contest_ = maker_->elsewhere()(PythonBriefing{briefing});
      started_ = nb::cast<bool>(contest_.attr("started"));
    });
    idle_.emplace();
  }
  ProcessStrategy(const ProcessStrategy&) = delete;
  ProcessStrategy& operator=(const ProcessStrategy&) = delete;
  ~ProcessStrategy() override { end(); }

  Action decide(const Sighting& seen) override {
    Action action = Action::forfeit(ForfeitReason::ended_early);
    call([&] {
      const nb::object answer = contest_.attr("decide")(seen.left, seen.ahead, seen.right);
      if (!answer.is_none())
        action = action_of(nb::cast<ActionFields>(answer));
      else if (!nb::cast<bool>(contest_.attr("died")))
        action = Action::forfeit(ForfeitReason::interrupted);
    });
    return action;
  }
  Action consider(const LogOddsMap& map, const SearchPlace& place, std::int64_t) override {
    return decide(map.sighting(place.pose));
  }
  void show(const Pose& pose, const Sighting& seen) override {
    call([&] {
      contest_.attr("show")(int{pose.cell.x}, int{pose.cell.y}, static_cast<int>(pose.heading), seen.left, seen.ahead,
                            seen.right);
    });
  }
  void carried(std::int64_t time) override {
    call([&] { contest_.attr("carried")(time); });
  }
  const Knowledge& knowledge() const override { return knowledge_; }
  StrategyReport report() override {
    end();
    return {.last_words = last_words_, .microseconds = microseconds_, .started = started_};
  }

 private:
  void end() {
    call([&] {
      contest_.attr("end")();
      last_words_ = nb::cast<std::string>(contest_.attr("last_words"));
      microseconds_ = nb::cast<std::optional<double>>(contest_.attr("microseconds"));
    });
  }

  /// Makes a call with the GIL. After a call that threw, the mouse counts as dead and later calls do nothing.
  template <class Calling>
  void call(Calling calling) {
    if (is_dead_) return;
    const nb::gil_scoped_acquire lock;
    try {
      calling();
    } catch (const std::exception& error) {
      is_dead_ = true;
      last_words_ = error.what();
    }
  }

  nb::gil_scoped_acquire lock_;  // otherwise each call would create a new Python thread state
  std::shared_ptr<const MouseMaker> maker_;
  nb::object contest_;
  Knowledge knowledge_;
  bool started_ = true, is_dead_ = false;
  std::string last_words_;
  std::optional<double> microseconds_;
  std::optional<nb::gil_scoped_release> idle_;  // last: the other members are destroyed with the GIL
};

/// A mouse in this process whose decisions another process asks for.
class NativeStrategy {
 public:
  NativeStrategy(nb::object maker, const PythonBriefing& told)
      : mouse_(make_python_strategy(std::make_shared<const MouseMaker>(std::move(maker), nb::none()), told.briefing,
                                    nullptr)) {}
  DrivingStrategy& mouse() { return *mouse_; }

 private:
  std::unique_ptr<DrivingStrategy> mouse_;
};

}  // namespace

std::unique_ptr<DrivingStrategy> make_live_strategy(const std::shared_ptr<const MouseMaker>& maker,
                                                    const Briefing& briefing, const std::atomic<bool>* stop) {
  bool here = false;
  {
    const nb::gil_scoped_acquire lock;
    here = maker->elsewhere().is_none();
  }
  if (here) return std::make_unique<ThreadStrategy>(maker, briefing, stop);
  return std::make_unique<ProcessStrategy>(maker, briefing);
}

void bind_live_strategies(nb::module_& module) {
  nb::class_<NativeStrategy>(module, "Strategy", "A mouse in a worker process, asked for one decision at a time.")
      .def(nb::init<nb::object, const PythonBriefing&>(), "maker"_a, "briefing"_a)
      .def_prop_ro("started", [](NativeStrategy& strategy) { return strategy.mouse().report().started; })
      .def(
          "decide",
          [](NativeStrategy& strategy, int left, int ahead, int right) {
            return fields_of(strategy.mouse().decide({left, ahead, right}));
          },
          "left"_a, "ahead"_a, "right"_a, "The action: kind, rotation in degrees, movement in cells, forfeit reason.")
      .def(
          "show",
          [](NativeStrategy& strategy, int x, int y, int heading, int left, int ahead, int right) {
            strategy.mouse().show({{x, y}, turned(Heading::north, heading)}, {left, ahead, right});
          },
          "x"_a, "y"_a, "heading"_a, "left"_a, "ahead"_a, "right"_a)
      .def(
          "carried", [](NativeStrategy& strategy, std::int64_t time) { strategy.mouse().carried(time); }, "time"_a)
      .def("last_words", [](NativeStrategy& strategy) { return std::string(strategy.mouse().report().last_words); })
      .def_prop_ro("microseconds", [](NativeStrategy& strategy) { return strategy.mouse().report().microseconds; });
}

}  // namespace labmouse::python
