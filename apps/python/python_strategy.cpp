#include "python_strategy.hpp"

#include <fmt/format.h>
#include <nanobind/stl/string.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#if defined(__GLIBCXX__)
#include <cxxabi.h>
#endif

#include "briefing.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "sightings.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace labmouse::python {
namespace {

/// Largest absolute rotation or movement that counts as an answer. The contest checks answers by its rules; this limit
/// only keeps numbers small enough for a record.
constexpr long farthest = 1'000'000;

/// The integer of an object; nothing if it is not one, or beyond `farthest`.
std::optional<int> number_of(PyObject* object) {
  const long value = PyLong_AsLong(object);
  if (value == -1 && PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    return std::nullopt;
  }
  if (value < -farthest || value > farthest) return std::nullopt;
  return static_cast<int>(value);
}

bool is_text(PyObject* object, const char* text) {
  return PyUnicode_Check(object) && PyUnicode_CompareWithASCIIString(object, text) == 0;
}

/// The action of an answer: (rotation, movement), "reset" or "forfeit"; nothing for any other answer.
std::optional<Action> action_of(PyObject* answer) {
  if (is_text(answer, "reset")) return Action::reset();
  if (is_text(answer, "forfeit")) return Action::forfeit(ForfeitReason::gave_up);
  if (!PyTuple_Check(answer) || PyTuple_Size(answer) != 2) return std::nullopt;
  PyObject* first = PyTuple_GetItem(answer, 0);
  PyObject* second = PyTuple_GetItem(answer, 1);
  // The reset in the protocol of capstone robots.
  if (is_text(first, "Reset") && is_text(second, "Reset")) return Action::reset();
  const auto rotation = number_of(first), movement = number_of(second);
  if (!rotation || !movement) return std::nullopt;
  return Action::step(*rotation, *movement);
}

/// The repr of an answer on one line. The answer may be anything, even an object whose repr raises.
std::string repr_of(const nb::object& answer) {
  try {
    return shown(nb::repr(answer).c_str());
  } catch (nb::python_error&) {
    return "something that cannot be shown";
  }
}

/// Calls an object of Python with one argument; null if it raised. If the interpreter shuts down while an abandoned
/// mouse still runs, Python up to 3.13 ends its thread by a forced unwind. A forced unwind that reaches a noexcept
/// function, such as a destructor, terminates the process. So the thread sleeps until the process ends instead.
nb::object called(nb::handle callable, nb::handle argument) {
  std::array<PyObject*, 2> arguments = {nullptr, argument.ptr()};
  const auto call = [&] {
    return PyObject_Vectorcall(callable.ptr(), &arguments[1], 1U | PY_VECTORCALL_ARGUMENTS_OFFSET, nullptr);
  };
#if defined(__GLIBCXX__)
  try {
    return nb::steal(call());
  } catch (abi::__forced_unwind&) {
    while (true) std::this_thread::sleep_for(std::chrono::hours(1));
  }
#else
  return nb::steal(call());
#endif
}

/// Acquires the GIL once, in its constructor: acquiring it for each decision would create a Python thread state each
/// time, which costs more than the decision. ThreadStrategy releases the GIL between calls. During a call, Python
/// itself switches threads while it runs a mouse's code.
class PythonStrategy final : public DrivingStrategy {
 public:
  PythonStrategy(const std::shared_ptr<const MouseMaker>& maker, const Briefing& briefing,
                 const std::atomic<bool>* stop)
      : maker_(maker), knowledge_(briefing.size), stop_(stop), in_seconds_(briefing.in_seconds()) {
    try {
      mouse_ = called(maker_->maker(), nb::cast(PythonBriefing{briefing}));
      if (!mouse_.is_valid()) throw nb::python_error();
      decide_ = mouse_.attr("decide");
      show_ = nb::getattr(mouse_, "show", nb::none());
      carried_ = nb::getattr(mouse_, "carried", nb::none());
      started_ = true;
    } catch (nb::python_error& error) {
      give_up(ForfeitReason::not_started, error);
    }
  }

  Action decide(const Sighting& seen) override {
    const auto begin = Clock::now();
    const Action action = decided(seen);
    spent_ += Clock::now() - begin;
    return action;
  }

  Action consider(const LogOddsMap& map, const SearchPlace& place, std::int64_t) override {
    return decide(map.sighting(place.pose));
  }
  void show(const Pose& pose, const Sighting& seen) override {
    tell(show_, [&] { show_(int{pose.cell.x}, int{pose.cell.y}, name_of(pose.heading).data(), sighting_of(seen)); });
  }
  void carried(std::int64_t time) override {
    tell(carried_, [&] { carried_(static_cast<double>(time) / 1e6); });
  }

  /// An empty map: labmouse cannot see what the object knows.
  const Knowledge& knowledge() const override { return knowledge_; }
  StrategyReport report() override {
    return {.last_words = last_words_,
            .microseconds = std::chrono::duration<double, std::micro>(spent_).count(),
            .started = started_};
  }

 private:
  using Clock = std::chrono::steady_clock;

  Action decided(const Sighting& seen) {
    if (reason_ != ForfeitReason::none) return Action::forfeit(reason_);
    if (is_stopped()) {
      reason_ = ForfeitReason::interrupted;
      return Action::forfeit(reason_);
    }
    const nb::object answer = called(decide_, sighting_of(seen));
    if (!answer.is_valid()) {
      nb::python_error error;
      give_up(ForfeitReason::ended_early, error);
      return Action::forfeit(reason_);
    }
    const auto action = action_of(answer.ptr());
    if (!action) {
      reason_ = ForfeitReason::invalid_answer;
      last_words_ =
          fmt::format("it answered {} instead of (rotation, movement), 'reset' or 'forfeit'", repr_of(answer));
      return Action::forfeit(reason_);
    }
    if (action->kind == Action::Kind::forfeit) {
      // In seconds, a mouse is asked again after its run, and 'forfeit' then means that it is done.
      reason_ = has_run_ ? ForfeitReason::finished : action->reason;
      if (!has_run_) last_words_ = "it answered 'forfeit'";
      return Action::forfeit(reason_);
    }
    has_run_ = has_run_ || (in_seconds_ && action->kind == Action::Kind::reset);
    return *action;
  }

  /// Calls an optional method of the mouse. If it raises, the next decision is a forfeit.
  template <class Telling>
  void tell(const nb::object& method, Telling telling) {
    if (reason_ != ForfeitReason::none || is_stopped() || !method.is_valid() || method.is_none()) return;
    try {
      telling();
    } catch (nb::python_error& error) {
      give_up(ForfeitReason::ended_early, error);
    }
  }

  bool is_stopped() const { return stop_ != nullptr && stop_->load(std::memory_order_relaxed); }

  /// Keeps the exception as last words: one sentence, then the traceback. In a stopped race the reason is always
  /// `interrupted`, because the exception is the interrupt.
  void give_up(ForfeitReason reason, nb::python_error& error) {
    reason_ = is_stopped() ? ForfeitReason::interrupted : reason;
    std::string kind = nb::cast<std::string>(nb::str(error.type().attr("__name__")));
    std::string message;
    try {
      message = nb::cast<std::string>(nb::str(error.value()));
    } catch (nb::python_error&) {
      message = "(what it says cannot be shown)";
    }
    last_words_ = fmt::format("it raised {}{}{}\n{}", kind, message.empty() ? "" : ": ",
                              message.substr(0, message.find('\n')), error.what());
  }

  nb::gil_scoped_acquire lock_;
  std::shared_ptr<const MouseMaker> maker_;
  nb::object mouse_, decide_, show_, carried_;
  Knowledge knowledge_;
  const std::atomic<bool>* stop_;
  const bool in_seconds_;
  bool started_ = false;
  bool has_run_ = false;
  ForfeitReason reason_ = ForfeitReason::none;
  std::string last_words_;
  Clock::duration spent_{};
};

}  // namespace

std::unique_ptr<DrivingStrategy> make_python_strategy(const std::shared_ptr<const MouseMaker>& maker,
                                                      const Briefing& briefing, const std::atomic<bool>* stop) {
  return std::make_unique<PythonStrategy>(maker, briefing, stop);
}

}  // namespace labmouse::python
