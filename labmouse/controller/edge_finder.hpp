// Detects beside a passing mouse where a wall begins or ends, or a lone post stands. That gives its longitudinal
// position.
//
//      wall ends          wall begins        post
//      ====o                    o====         o          beside the mouse, that drives to the right
//
// Method: the share (reading over the reading of a whole wall) is integrated over a stretch around a grid line. The
// integral gives the position of an edge, the first moment that of a post. So a single reading has little weight.
#pragma once

#include <optional>

namespace labmouse {

/// What a mouse passes at a grid line: the end of a wall, the beginning of a wall, or a post alone.
enum class Edge { falls, rises, post };

/// An edge, and how many mm behind the grid line it was measured; 0 if the position estimate is exact.
struct SeenEdge {
  Edge edge = Edge::post;
  double behind = 0.0;
};

class EdgeFinder {
 public:
  /// Observes `reach` mm before and behind each line; walls and posts are twice `half_wall` thick.
  EdgeFinder(double reach, double half_wall) : reach_(reach), half_wall_(half_wall) {}

  /// Whether pass() has to be called at this place, in mm behind the nearest line (negative: before it).
  bool needs(double behind) const { return running_ || (behind < 0.0 && behind > -1.5 * reach_); }
  /// Adds a reading: the number of the nearest line, the place in mm behind it, and the share of a whole wall. Returns
  /// the edge at the end of a stretch, if there is one.
  std::optional<SeenEdge> pass(int line, double behind, double share);
  void forget() { running_ = false; }

 private:
  std::optional<SeenEdge> edge() const;
  void begin(int line, double behind, double share);

  double reach_, half_wall_;
  bool running_ = false;
  int line_ = 0;
  double last_ = 0.0, last_share_ = 0.0;
  double sum_ = 0.0, moment_ = 0.0;
  double first_sum_ = 0.0, first_length_ = 0.0;  ///< over the first part
  double end_sum_ = 0.0, end_length_ = 0.0;      ///< over the last part
};

}  // namespace labmouse
