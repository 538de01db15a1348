#include "python_mind.hpp"

#include <fmt/format.h>
#include <nanobind/stl/string.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "bindings.hpp"
#include "briefing.hpp"
#include "errors.hpp"
#include "labmouse/contest/drive.hpp"
#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/mazes/maze_link.hpp"
#include "labmouse/lab/robots/drive_rules_file.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/lab/seconds/seconds_entry.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "sightings.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace labmouse::python {
namespace {

/// Wrong rotations and movements are part of a contest, within what a record can hold, as for guests.
constexpr long farthest = 1'000'000;

/// Kind, rotation, movement and reason, from one process to another of the same build.
using PackedAction = std::array<std::int32_t, 4>;

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

/// What an answer looks like, which may be anything, one that cannot be shown among them.
std::string repr_of(const nb::object& answer) {
  try {
    return shown(nb::repr(answer).c_str());
  } catch (nb::python_error&) {
    return "something that cannot be shown";
  }
}

/// Where mice decide, and what stops them. A mouse that never answers hears of it by an exception alone.
class DecidingThreads {
 public:
  void enter(const std::atomic<bool>* stop) {
    const std::lock_guard lock(mutex_);
    threads_.emplace_back(stop, PyThread_get_thread_ident());
  }
  void leave(const std::atomic<bool>* stop) {
    const std::lock_guard lock(mutex_);
    const auto found = std::find(threads_.begin(), threads_.end(), std::pair(stop, PyThread_get_thread_ident()));
    if (found != threads_.end()) threads_.erase(found);
  }
  void interrupt(const std::atomic<bool>* stop) {
    const std::lock_guard lock(mutex_);
    for (const auto& [flag, thread] : threads_)
      if (flag == stop) PyThreadState_SetAsyncExc(thread, PyExc_KeyboardInterrupt);
  }

 private:
  std::mutex mutex_;  // for interpreters that run several threads at a time
  std::vector<std::pair<const std::atomic<bool>*, unsigned long>> threads_;
};

DecidingThreads& deciding_threads() {
  static DecidingThreads threads;
  return threads;
}

/// Holds the interpreter's lock from its making to its end, which are in the same thread: to take it once a decision
/// costs more than the decision. Python lets other threads in while it runs a mouse's own code.
class PythonMind final : public Strategy {
 public:
  PythonMind(const std::shared_ptr<const MouseMaker>& maker, const Briefing& briefing, const std::atomic<bool>* stop)
      : maker_(maker), knowledge_(briefing.size), stop_(stop), in_seconds_(briefing.in_seconds()) {
    deciding_threads().enter(stop_);
    try {
      mouse_ = maker_->maker()(nb::cast(PythonBriefing{briefing}));
      decide_ = mouse_.attr("decide");
      started_ = true;
    } catch (nb::python_error& error) {
      give_up(ForfeitReason::not_started, error);
    }
  }

  PythonMind(const PythonMind&) = delete;
  PythonMind& operator=(const PythonMind&) = delete;
  ~PythonMind() override { deciding_threads().leave(stop_); }

  Action decide(const Sighting& seen) override {
    if (reason_ != ForfeitReason::none) return Action::forfeit(reason_);
    if (is_stopped()) {
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
      last_words_ =
          fmt::format("it answered {} instead of (rotation, movement), 'reset' or 'forfeit'", repr_of(answer));
      return Action::forfeit(reason_);
    }
    if (action->kind == Action::Kind::forfeit) {
      // After a run in seconds it is asked whether there is more to do.
      reason_ = has_run_ ? ForfeitReason::finished : action->reason;
      if (!has_run_) last_words_ = "it answered 'forfeit'";
      return Action::forfeit(reason_);
    }
    has_run_ = has_run_ || (in_seconds_ && action->kind == Action::Kind::reset);
    return *action;
  }

  /// Nothing: what it believes nobody sees.
  const Knowledge& knowledge() const override { return knowledge_; }
  bool started() const override { return started_; }
  std::string_view last_words() override { return last_words_; }

 private:
  bool is_stopped() const { return stop_ != nullptr && stop_->load(std::memory_order_relaxed); }

  /// Keeps what it raised: a sentence, then the traceback. Once the race is stopped, that was the end of it.
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
  nb::object mouse_, decide_;
  Knowledge knowledge_;
  const std::atomic<bool>* stop_;
  const bool in_seconds_;
  bool started_ = false;
  bool has_run_ = false;
  ForfeitReason reason_ = ForfeitReason::none;
  std::string last_words_;
};

void append(std::string& actions, const Action& action) {
  const PackedAction packed = {static_cast<std::int32_t>(action.kind), action.rotation, action.movement,
                               static_cast<std::int32_t>(action.reason)};
  actions.append(reinterpret_cast<const char*>(packed.data()), sizeof packed);
}

/// The actions of a mouse whose process died.
std::string death() {
  std::string actions;
  append(actions, Action::forfeit(ForfeitReason::died));
  return actions;
}

/// Keeps what a mouse did, for another process.
class KeptMind final : public Strategy {
 public:
  explicit KeptMind(std::unique_ptr<Strategy> mouse) : mouse_(std::move(mouse)) {}

  Action decide(const Sighting& seen) override {
    const Action action = mouse_->decide(seen);
    append(actions_, action);
    return action;
  }
  const Knowledge& knowledge() const override { return mouse_->knowledge(); }

  /// The actions, the last words and whether it started.
  nb::tuple played() const {
    return nb::make_tuple(nb::bytes(actions_.data(), actions_.size()), std::string(mouse_->last_words()),
                          mouse_->started());
  }

 private:
  std::unique_ptr<Strategy> mouse_;
  std::string actions_;
};

/// What a mouse did in another process, step by step.
class PlayedMind final : public Strategy {
 public:
  PlayedMind(Size size, std::string_view actions, std::string words, bool started)
      : knowledge_(size), last_words_(std::move(words)), started_(started) {
    actions_.resize(actions.size() / sizeof(PackedAction));
    std::memcpy(actions_.data(), actions.data(), actions_.size() * sizeof(PackedAction));
  }

  Action decide(const Sighting&) override {
    if (next_ >= actions_.size()) return Action::forfeit(ForfeitReason::interrupted);
    const PackedAction& packed = actions_[next_++];
    return {static_cast<Action::Kind>(packed[0]), packed[1], packed[2], static_cast<ForfeitReason>(packed[3])};
  }
  const Knowledge& knowledge() const override { return knowledge_; }
  bool started() const override { return started_; }
  std::string_view last_words() override { return last_words_; }

 private:
  Knowledge knowledge_;
  std::vector<PackedAction> actions_;
  std::string last_words_;
  bool started_;
  std::size_t next_ = 0;
};

/// The mind that another process played, given what play() takes behind the maker; null where the contest is to be held
/// here.
template <class... Contest>
std::unique_ptr<Strategy> played_elsewhere(const MouseMaker& maker, const Maze& maze, const Contest&... contest) {
  const nb::gil_scoped_acquire lock;
  if (maker.elsewhere().is_none()) return nullptr;
  try {
    const nb::object played = maker.elsewhere()(link_of({"", maze}), contest...);
    if (played.is_none()) return nullptr;
    const auto actions = nb::cast<nb::bytes>(played[0]);
    return std::make_unique<PlayedMind>(maze.size(), std::string_view(actions.c_str(), actions.size()),
                                        nb::cast<std::string>(played[1]), nb::cast<bool>(played[2]));
  } catch (nb::python_error& error) {
    return std::make_unique<PlayedMind>(maze.size(), death(), error.what(), true);
  }
}

std::unique_ptr<Strategy> mind_of(nb::object maker, const Briefing& briefing) {
  return std::make_unique<PythonMind>(std::make_shared<const MouseMaker>(std::move(maker), nb::none()), briefing,
                                      nullptr);
}

Maze maze_of(const std::string& link) {
  ReadLinkResult read = read_link(link);
  if (!read.maze) throw UserError(read.error);
  return std::move(read.maze->maze);
}

/// Holds a contest in steps in this process, for another one.
nb::tuple play_in_steps(nb::object maker, const std::string& link, int budget, int stride, std::uint64_t seed) {
  const Maze maze = maze_of(link);
  Rules rules;
  rules.budget = budget;
  rules.stride = stride;
  KeptMind mind(mind_of(std::move(maker), brief(maze, rules, seed)));
  run(maze, rules, mind);
  return mind.played();
}

/// A robot and rules, as many contests have them.
struct Driving {
  DriveModel model;
  DriveRules rules;
};

/// Kept, since a model takes longer to make than a contest to hold. Only with the interpreter's lock.
const Driving& driving_by(const std::string& robot, const std::string& rules) {
  static std::map<std::pair<std::string, std::string>, Driving> kept;
  const auto known = kept.find({robot, rules});
  if (known != kept.end()) return known->second;
  FoundRobot found = find_robot(robot);
  if (!found.errors.empty()) throw UserError(fmt::format("{}", fmt::join(found.errors, "\n")));
  FoundRules named = find_rules(rules);
  if (!named.errors.empty()) throw UserError(fmt::format("{}", fmt::join(named.errors, "\n")));
  Driving& driving = kept[{robot, rules}];
  driving = {std::move(found.model), std::move(named.rules)};
  share_route_tables(driving.model);
  return driving;
}

/// The same in seconds.
nb::tuple play_in_seconds(nb::object maker, const std::string& link, const std::string& robot, const std::string& rules,
                          std::uint64_t seed) {
  const Maze maze = maze_of(link);
  const Driving& driving = driving_by(robot, rules);
  KeptMind mind(mind_of(std::move(maker), brief(maze, driving.rules, driving.model, seed)));
  drive(maze, driving.rules, driving.model, mind);
  return mind.played();
}

}  // namespace

void stop(Work& work) {
  work.stop();
  deciding_threads().interrupt(&work.stopped());
}

Contestant python_contestant(OwnMouse own, const WorldSettings& settings, const std::atomic<bool>* stop) {
  Contestant mouse;
  mouse.name = own.name;
  mouse.uses_chance = own.uses_chance;
  mouse.identity = [identity = own.identity] { return identity; };
  const auto shared = std::make_shared<const MouseMaker>(std::move(own.maker), std::move(own.elsewhere));
  mouse.make = [shared, stop](const Maze& maze, const Rules& rules, std::uint64_t seed) -> std::unique_ptr<Strategy> {
    if (auto played = played_elsewhere(*shared, maze, rules.budget, rules.stride, seed)) return played;
    return std::make_unique<PythonMind>(shared, brief(maze, rules, seed), stop);
  };
  mouse.drive = [shared, stop, robot = std::string(value_of(seconds_entry, settings, "robot")),
                 rules = std::string(value_of(seconds_entry, settings, "rules"))](
                    const Maze& maze, const Briefing& briefing) -> std::unique_ptr<Strategy> {
    if (auto played = played_elsewhere(*shared, maze, robot, rules, briefing.seed)) return played;
    return std::make_unique<PythonMind>(shared, briefing, stop);
  };
  return mouse;
}

void bind_minds(nb::module_& module) {
  module.def(
      "play", &play_in_steps, "maker"_a, "link"_a, "budget"_a, "stride"_a, "seed"_a,
      nb::sig("def play(maker: object, link: str, budget: int, stride: int, seed: int) -> tuple[bytes, str, bool]"),
      "Holds a contest in steps for another process: the actions, the last words and whether the mouse started.");
  module.def(
      "play", &play_in_seconds, "maker"_a, "link"_a, "robot"_a, "rules"_a, "seed"_a,
      nb::sig("def play(maker: object, link: str, robot: str, rules: str, seed: int) -> tuple[bytes, str, bool]"),
      "The same in seconds.");
  module.def(
      "death",
      [] {
        const std::string actions = death();
        return nb::bytes(actions.data(), actions.size());
      },
      "What a mouse did whose process died.");
}

}  // namespace labmouse::python
