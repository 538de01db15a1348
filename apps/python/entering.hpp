// Resolves the mice, mazes and world that a user of Python asks for.
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

/// Mice, mazes and world as the user gave them, not yet checked.
struct Choice {
  /// (name, SPEC) of each entry. With a name, the SPEC must stand for exactly one mouse; with an empty name, its mice
  /// keep the names that the SPEC gives them.
  std::vector<std::pair<std::string, std::string>> specs;
  std::vector<OwnMouse> own;
  std::vector<NamedMaze> mazes;  ///< empty: the built-in ones
  std::string world;             ///< empty: the first one that takes the mice
  WorldSettings settings;        ///< only those that the user gave
  std::string python;            ///< the interpreter of capstone robots; empty: python3 of PATH
  std::string label;             ///< see ExternalOptions::label
};

/// A world with its mice, and the mazes of the choice that this world accepts.
struct Field {
  Entry entry;
  std::vector<NamedMaze> mazes;
  std::vector<SkippedFile> skipped;
  std::vector<std::string> remarks;
};

/// Checks the choice and makes its mice. Without mice, all built-in mice of the world race. External mice and mice in
/// Python end once `stop` is true. Throws UserError.
Field enter(Choice choice, const std::atomic<bool>* stop);

/// The world of a choice that names no mice; throws UserError.
Entry world_of(const std::string& world, const WorldSettings& settings);

}  // namespace labmouse::python
