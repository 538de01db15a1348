#include "labmouse/controller/edge_finder.hpp"

#include <algorithm>

namespace labmouse {
namespace {

/// Length of the first and the last part of a stretch, as a share of the reach.
constexpr double part = 0.25;

}  // namespace

void EdgeFinder::begin(int line, double behind, double share) {
  running_ = true;
  line_ = line;
  last_ = behind;
  last_share_ = share;
  sum_ = moment_ = first_sum_ = first_length_ = end_sum_ = end_length_ = 0.0;
}

std::optional<SeenEdge> EdgeFinder::pass(int line, double behind, double share) {
  const double step = behind - last_;
  // No edge is detected if the mouse reverses, jumps, or starts in the middle of a stretch.
  if (running_ && (line != line_ || step < 0.0 || step > reach_ / 2.0)) running_ = false;
  if (!running_) {
    if (behind < -reach_ && behind > -1.5 * reach_) begin(line, behind, share);
    return std::nullopt;
  }
  // The part of the step inside the stretch, and the share interpolated at its middle.
  const double from = std::max(last_, -reach_), to = std::min(behind, reach_), length = to - from;
  const double middle = (from + to) / 2.0;
  const double mean = step > 0.0 ? last_share_ + (share - last_share_) * (middle - last_) / step : share;
  last_ = behind;
  last_share_ = share;
  if (length <= 0.0) return std::nullopt;
  sum_ += mean * length;
  moment_ += mean * middle * length;
  if (middle < -(1.0 - part) * reach_) {
    first_sum_ += mean * length;
    first_length_ += length;
  }
  if (middle > (1.0 - part) * reach_) {
    end_sum_ += mean * length;
    end_length_ += length;
  }
  if (behind < reach_) return std::nullopt;
  running_ = false;
  return edge();
}

std::optional<SeenEdge> EdgeFinder::edge() const {
  if (first_length_ <= 0.0 || end_length_ <= 0.0) return std::nullopt;
  constexpr double much = 0.6, little = 0.12;
  const double first = first_sum_ / first_length_, end = end_sum_ / end_length_;
  // A post reaches half a wall to both sides, so a wall's edge lies that far from the line.
  if (first > much && end < little) return SeenEdge{Edge::falls, sum_ / first - reach_ - half_wall_};
  if (first < little && end > much) return SeenEdge{Edge::rises, reach_ - sum_ / end + half_wall_};
  if (first < little && end < little && sum_ > half_wall_ && sum_ < 4.0 * half_wall_)
    return SeenEdge{Edge::post, moment_ / sum_};
  return std::nullopt;
}

}  // namespace labmouse
