#include "python_mind.hpp"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "bindings.hpp"
#include "briefing.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "sightings.hpp"

namespace nb = nanobind;

namespace labmouse::python {
namespace {

/// Wrong rotations and movements are part of a contest, within what a record can hold, as for guests.
constexpr long farthest = 1'000'000;

/// The whole number of an object; nothing where it is none, or too large.
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

/// The action of an answer: (rotation, movement), "reset" or "forfeit"; nothing where it is none of them.
std::optional<Action> action_of(PyObject* answer) {
  if (is_text(answer, "reset")) return Action::reset();
  if (is_text(answer, "forfeit")) return Action::forfeit(ForfeitReason::gave_up);
  if (!PyTuple_Check(answer) || PyTuple_Size(answer) != 2) return std::nullopt;
  PyObject* first = PyTuple_GetItem(answer, 0);
  PyObject* second = PyTuple_GetItem(answer, 1);
  // As robots of the capstone project say it.
  if (is_text(first, "Reset") && is_text(second, "Reset")) return Action::reset();
  const auto rotation = number_of(first), movement = number_of(second);
  if (!rotation || !movement) return std::nullopt;
  return Action::step(*rotation, *movement);
}

/// Holds the interpreter's lock from its making to its end, which are in the same thread: to take it once a decision
/// costs more than the decision. Python lets other threads in while it runs a mouse's own code.
class PythonMind final : public Strategy {
 public:
  PythonMind(const std::shared_ptr<const MouseMaker>& maker, const Briefing& briefing, const std::atomic<bool>* stop)
      : maker_(maker), knowledge_(briefing.size), stop_(stop) {
    try {
      mouse_ = maker_->maker()(nb::cast(PythonBriefing{briefing}));
      decide_ = mouse_.attr("decide");
      started_ = true;
    } catch (nb::python_error& error) {
      give_up(ForfeitReason::not_started, error);
    }
  }

  Action decide(const Sighting& seen) override {
    if (reason_ != ForfeitReason::none) return Action::forfeit(reason_);
    if (stop_ != nullptr && stop_->load(std::memory_order_relaxed)) {
      reason_ = ForfeitReason::interrupted;
      return Action::forfeit(reason_);
    }
    std::array<PyObject*, 2> arguments = {nullptr, sighting_of(seen).ptr()};
    const nb::object answer =
        nb::steal(PyObject_Vectorcall(decide_.ptr(), &arguments[1], 1U | PY_VECTORCALL_ARGUMENTS_OFFSET, nullptr));
    if (!answer.is_valid()) {
      nb::python_error error;
      give_up(ForfeitReason::died, error);
      return Action::forfeit(reason_);
    }
    const auto action = action_of(answer.ptr());
    if (!action) {
      reason_ = ForfeitReason::rubbish;
      last_words_ = fmt::format("it answered {} instead of (rotation, movement), 'reset' or 'forfeit'",
                                shown(nb::repr(answer).c_str()));
      return Action::forfeit(reason_);
    }
    if (action->kind == Action::Kind::forfeit) {
      reason_ = action->reason;
      last_words_ = "it answered 'forfeit'";
    }
    return *action;
  }

  /// Nothing: what it believes nobody sees.
  const Knowledge& knowledge() const override { return knowledge_; }
  bool started() const override { return started_; }
  std::string_view last_words() override { return last_words_; }

 private:
  /// Keeps what it raised: a sentence, then the traceback.
  void give_up(ForfeitReason reason, nb::python_error& error) {
    reason_ = reason;
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
  nb::object mouse_, decide_;
  Knowledge knowledge_;
  const std::atomic<bool>* stop_;
  bool started_ = false;
  ForfeitReason reason_ = ForfeitReason::none;
  std::string last_words_;
};

}  // namespace

Contestant python_contestant(const std::string& name, nb::object maker, bool uses_chance,
                             const std::atomic<bool>* stop) {
  Contestant mouse;
  mouse.name = name;
  mouse.uses_chance = uses_chance;
  mouse.make = [shared = std::make_shared<const MouseMaker>(std::move(maker)), stop](
                   const Maze& maze, const Rules& rules, std::uint64_t seed) -> std::unique_ptr<Strategy> {
    return std::make_unique<PythonMind>(shared, brief(maze, rules, seed), stop);
  };
  return mouse;
}

}  // namespace labmouse::python
