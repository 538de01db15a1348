// The problems that readers find, and their wording.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "labmouse/maze/formats/read_result.hpp"

namespace labmouse::formats {

/// The problems of one input in the order in which they are found; those past most_problems are dropped.
class ProblemList {
 public:
  void add(int line, int column, std::string reason) {
    if (!full()) problems_.push_back({line, column, std::move(reason)});
  }
  bool empty() const { return problems_.empty(); }
  /// Whether no more problems are listed; a reader may stop then.
  bool full() const { return problems_.size() >= most_problems; }

  const std::vector<Problem>& all() const { return problems_; }

  /// The result of failed reading; the list must not be empty.
  ReadResult failure() const { return {std::nullopt, problems_}; }

 private:
  std::vector<Problem> problems_;
};

/// The result of reading that failed for a single reason.
ReadResult failure(int line, int column, std::string reason);

/// A maze, or a partial map where some of its walls are unseen.
ReadResult map_of(const Maze& known, const WallSet& unseen);

/// A cell as reasons name it: "(3,4)".
std::string name_of(Cell cell);

/// A piece of the input between single quotes: shortened, and made printable whatever its bytes are.
std::string quoted(std::string_view text);

/// Why an open side of a cell is wrong when it lies on the border.
std::string open_border(Cell cell, Heading side);

}  // namespace labmouse::formats
