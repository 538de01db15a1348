// Shows drawings of a maze as an animation.
#pragma once

#include <string>

#include "labmouse/grid/cell.hpp"

namespace labmouse::cli {

/// Draws frames over each other on a terminal; elsewhere one below the other.
class Frames {
 public:
  /// `lines`: number of lines below the drawing. Throws UsageError where the terminal is too small for a maze of that
  /// size.
  Frames(Size size, int lines);

  /// Whether frames replace each other; the caller then waits between them.
  bool moving() const { return moving_; }
  void show(const std::string& frame) const;

 private:
  bool moving_;
};

}  // namespace labmouse::cli
