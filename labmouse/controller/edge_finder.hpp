// Where a wall begins or ends, or a lone post stands, beside a mouse that drives past: what tells it how far it is.
//
//      wall ends          wall begins        post
//      ====o                    o====         o          beside the mouse, that drives to the right
//
// Method: over a stretch about a line of the grid, the share is summed up. The sum says where the edge is, the sum
// weighed with the place where the post is; no single reading counts for much.
#pragma once

#include <optional>

namespace labmouse {

/// What stands on both sides of a line, as a mouse passes it.
enum class Edge { falls, rises, post };

/// An edge, and how many mm behind the line of the grid it was seen; it is at 0 where the mouse knows its place.
struct SeenEdge {
  Edge edge = Edge::post;
  double behind = 0.0;
};

class EdgeFinder {
 public:
  /// Looks from so many mm before a line to as many behind it; walls and posts are twice `half_wall` thick.
  EdgeFinder(double reach, double half_wall) : reach_(reach), half_wall_(half_wall) {}

  /// Whether it needs to know of a place in mm behind the nearest line.
  bool needs(double behind) const { return running_ || (behind < 0.0 && behind > -1.5 * reach_); }
  /// A place in mm behind the nearest line, which has that number, and the share of a wall that is seen there. Returns
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
