// The result of reading a maze file: a maze, or a list of problems.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// What is wrong with an input, and where. Line and column count from 1; both are 0 for the input as a whole.
struct Problem {
  int line = 0;
  int column = 0;
  std::string reason;

  friend bool operator==(const Problem&, const Problem&) = default;
};

/// The most problems that are listed for one input.
inline constexpr std::size_t most_problems = 10;

/// A map in which some inner walls were not seen.
struct PartialMap {
  Maze known;      ///< with the unseen walls open
  WallSet unseen;  ///< not empty in a ReadResult
};

/// An opening in the border of a file's maze.
struct BorderGap {
  Cell cell;
  Heading side = Heading::north;

  friend bool operator==(const BorderGap&, const BorderGap&) = default;
};

/// A maze, or what is wrong with its file: exactly one of the two is there.
struct ReadResult {
  std::optional<Maze> maze = {};
  std::vector<Problem> problems = {};
  /// How the file was read, where it does not state it: "rows of cells from the north, walls 1 north, 2 east, ...".
  std::string reading = {};
  /// What the user should know of the maze, a sentence each: closed gaps in the border, other possible readings.
  std::vector<std::string> notes = {};
  /// What the file holds where it is a partial map; unless the user chose to close its unseen walls, the problem is
  /// then that it is no maze.
  std::optional<PartialMap> partial = {};
  /// Openings in the border, such as an entrance and an exit. The border of the maze is closed there.
  std::vector<BorderGap> gaps = {};
  /// If all that is wrong are a few cells that contradict their neighbours: the maze with a wall wherever one of the
  /// two cells has one.
  std::optional<Maze> repaired = {};
};

}  // namespace labmouse
