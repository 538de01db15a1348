#include "labmouse/lab/replays/mms_walk.hpp"

#include <algorithm>
#include <cstdlib>

namespace labmouse {
namespace {

/// As a drawing can show it.
Pose pose_of(const HalfPose& pose) { return {cell_of(pose.place), heading_of(pose.heading)}; }

int sign(int value) { return (value > 0) - (value < 0); }

}  // namespace

MmsWalk::MmsWalk(const HalfPose& start) : last_(start), poses_{pose_of(start)} {
  visited_.insert(cell_of(start.place));
}

void MmsWalk::add(const MmsEvent& event) {
  if (event.pose == last_) return;
  HalfPlace place = last_.place;
  const int dx = event.pose.place.x - place.x, dy = event.pose.place.y - place.y;
  // A move that is not straight is a reset: the mouse was carried to the start by hand.
  if (event.line != "ackReset" && (dx == 0 || dy == 0 || std::abs(dx) == std::abs(dy)))
    for (int steps = std::max(std::abs(dx), std::abs(dy)); steps > 0; --steps) {
      const HalfPlace next = {place.x + sign(dx), place.y + sign(dy)};
      // The cell of a half step is that of its middle.
      visited_.insert({(place.x + next.x) / 4, (place.y + next.y) / 4});
      place = next;
    }
  last_ = event.pose;
  poses_.push_back(pose_of(event.pose));
}

}  // namespace labmouse
