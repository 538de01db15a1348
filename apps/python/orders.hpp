// Mice and worlds as Python passes them, in types that nanobind converts, and their conversion to a Choice.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "entering.hpp"

namespace labmouse::python {

/// A mouse in Python: the fields of OwnMouse in order.
using GivenMouse = std::tuple<std::string, nanobind::object, bool, nanobind::object, std::string>;
/// Choice::specs, mice in Python, Choice::python and Choice::label.
using GivenMice =
    std::tuple<std::vector<std::pair<std::string, std::string>>, std::vector<GivenMouse>, std::string, std::string>;
/// The name of a world, or empty, and its settings.
using GivenWorld = std::pair<std::string, std::map<std::string, std::string>>;

inline Choice choice_of(const GivenMice& mice, std::vector<NamedMaze> mazes, const GivenWorld& world) {
  Choice choice;
  choice.specs = std::get<0>(mice);
  for (const auto& [name, maker, uses_chance, elsewhere, identity] : std::get<1>(mice))
    choice.own.push_back({name, maker, uses_chance, elsewhere, identity});
  choice.python = std::get<2>(mice);
  choice.label = std::get<3>(mice);
  choice.mazes = std::move(mazes);
  choice.world = world.first;
  choice.settings = WorldSettings(world.second.begin(), world.second.end());
  return choice;
}

}  // namespace labmouse::python
