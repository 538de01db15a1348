// Drawings of a maze as an animation.
#pragma once

#include <string>

#include "labmouse/grid/cell.hpp"

namespace labmouse::cli {

/// Over each other on a terminal, one below the other elsewhere.
class Frames {
 public:
  /// `lines`: below the drawing. Throws UsageError where the terminal is too small for a maze of that size.
  Frames(Size size, int lines);

  /// Whether they move: then each one shall stay for a while.
  bool moving() const { return moving_; }
  void show(const std::string& frame) const;

 private:
  bool moving_;
};

}  // namespace labmouse::cli
