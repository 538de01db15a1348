// Small races to test with.
#pragma once

#include <string>
#include <vector>

#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/steps/steps_world.hpp"
#include "tests/drawn_maze.hpp"

namespace labmouse::test {

/// Four steps of one way: solved by everybody.
inline NamedMaze corridor() {
  return {"corridor", drawn(R"(
    o---o---o---o---o
    | S             |
    o---o---o---o   o
    | G             |
    o---o---o---o---o
  )")};
}

/// The short way in looks like the long one: floods go round the outside first.
inline NamedMaze loop() {
  return {"loop", drawn(R"(
    o---o---o---o---o---o
    |                   |
    o   o---o---o---o   o
    |   |           |   |
    o   o---o   o   o   o
    |   |     G |   |   |
    o   o   o---o   o   o
    |       |       |   |
    o   o---o   o---o   o
    | S |               |
    o---o---o---o---o---o
  )")};
}

/// Four cells: the shortest run drives into the second and sees the third.
inline NamedMaze hook() {
  return {"hook", drawn(R"(
    o---o---o
    | G |   |
    o   o   o
    | S     |
    o---o---o
  )")};
}

/// Nobody arrives.
inline NamedMaze without_route() {
  return {"without-route", drawn(R"(
    o---o---o
    | S | G |
    o---o---o
  )")};
}

inline std::vector<Contestant> mice(std::string_view specs) { return read_specs(specs).contestants; }

/// The order of a race in steps.
inline RaceOrder in_steps(const Rules& rules = {}) {
  RaceOrder order;
  order.world = steps_world(rules);
  return order;
}

/// A race in the three mazes.
inline Race race_of(std::string_view specs, const RaceOrder& order = in_steps()) {
  return hold_race(mice(specs), {loop(), corridor(), without_route()}, order);
}

}  // namespace labmouse::test
