#include "own_mouse.hpp"

#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <cstring>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>

#include "labmouse/contest/simulator.hpp"
#include "labmouse/lab/mazes/maze_link.hpp"
#include "labmouse/lab/mice/stoppable.hpp"
#include "live_strategy.hpp"
#include "playing.hpp"

namespace nb = nanobind;

namespace labmouse::python {
namespace {

using Maker = std::shared_ptr<const MouseMaker>;

Played read_played(const nb::object& told) {
  const auto [actions, words, started, microseconds] = nb::cast<std::tuple<nb::bytes, std::string, bool, double>>(told);
  Played played{std::vector<PackedAction>(actions.size() / sizeof(PackedAction)), words, started, microseconds};
  std::memcpy(played.actions.data(), actions.c_str(), played.actions.size() * sizeof(PackedAction));
  return played;
}

/// What another process played; nothing where the contest is to be held here.
std::optional<Played> played_elsewhere(const MouseMaker& maker, const Maze& maze, const Rules& rules,
                                       std::uint64_t seed) {
  const nb::gil_scoped_acquire lock;
  if (maker.elsewhere().is_none()) return std::nullopt;
  try {
    const nb::object told = maker.elsewhere()(link_of({"", maze}), rules.budget, rules.stride, seed);
    return told.is_none() ? std::nullopt : std::optional(read_played(told));
  } catch (nb::python_error& error) {
    return death(error.what());
  }
}

/// The contest in which the mouse did that, as far as it goes.
ContestElsewhere played_again(const Maze& maze, const Rules& rules, Played played, const std::atomic<bool>* stop) {
  const double microseconds = played.microseconds;
  const auto mind = make_played_mind(maze.size(), std::move(played));
  Stoppable stoppable(*mind, stop);
  return {run(maze, rules, stoppable), mind->started(), microseconds};
}

ContestElsewhere contest_in_steps(const Maker& maker, const Maze& maze, const Rules& rules, std::uint64_t seed,
                                  const std::atomic<bool>* stop) {
  if (auto played = played_elsewhere(*maker, maze, rules, seed))
    return played_again(maze, rules, std::move(*played), stop);
  Played played =
      play_apart([=](Playing& playing) { playing.keep(play_in_steps(maker, maze, rules, seed, playing)); }, stop);
  if (played.record) return {std::move(*played.record), played.started, played.microseconds};
  // The mouse was left behind: what it did until then.
  return played_again(maze, rules, std::move(played), nullptr);
}

}  // namespace

Contestant python_contestant(OwnMouse own, const std::atomic<bool>* stop) {
  Contestant mouse;
  mouse.name = own.name;
  // Its name may be that of a mouse of ours.
  mouse.spec = "python";
  mouse.uses_chance = own.uses_chance;
  mouse.identity = [identity = own.identity] { return identity; };
  const auto maker = std::make_shared<const MouseMaker>(std::move(own.maker), std::move(own.elsewhere));
  mouse.elsewhere = [maker, stop](const std::string&, const Maze& maze, const Rules& rules, std::uint64_t seed) {
    return contest_in_steps(maker, maze, rules, seed, stop);
  };
  mouse.drive = [maker, stop](const Maze&, const Briefing& briefing) {
    return make_live_strategy(maker, briefing, stop);
  };
  return mouse;
}

}  // namespace labmouse::python
