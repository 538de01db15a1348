// Who races where, from what a user of Python gave.
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <string>
#include <utility>
#include <vector>

#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/worlds/entering.hpp"
#include "own_mouse.hpp"

namespace labmouse::python {

/// What a user chose.
struct Choice {
  /// SPECs of mice; each has the name of the one mouse that it is before it, or an empty one.
  std::vector<std::pair<std::string, std::string>> specs;
  std::vector<OwnMouse> own;
  std::vector<NamedMaze> mazes;  ///< none: the built-in ones
  std::string world;             ///< empty: the one that suits the mice
  WorldSettings settings;        ///< those that were given
  std::string python;            ///< that runs capstone robots
  std::string label;             ///< as of ExternalOptions
};

/// Mice in their world, and the mazes that it takes.
struct Field {
  Entry entry;
  std::vector<NamedMaze> mazes;
  std::vector<SkippedFile> skipped;
  std::vector<std::string> remarks;
};

/// Throws UserError. Where there is no mouse, all built-in mice race that the world takes. Once `stop`
/// is true, external mice and mice in Python are ended.
Field enter(Choice choice, const std::atomic<bool>* stop);

/// The world of a choice that names no mice; throws UserError.
std::shared_ptr<const World> world_of(const std::string& world, const WorldSettings& settings);

}  // namespace labmouse::python
