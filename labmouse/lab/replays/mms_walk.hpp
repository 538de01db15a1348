// Where a mouse of mms went, cell by cell.
#pragma once

#include <vector>

#include "labmouse/external/mms/host.hpp"
#include "labmouse/grid/cell_set.hpp"
#include "labmouse/mouse/pose.hpp"

namespace labmouse {

/// Collects the cells that it drove through, and its places as poses of cells, which a drawing can show.
class MmsWalk {
 public:
  explicit MmsWalk(const HalfPose& start);

  void add(const MmsEvent& event);

  const CellSet& visited() const { return visited_; }
  /// Where each move ended, the start first; a place between two cells counts for the nearer of them to the south-west.
  const std::vector<Pose>& poses() const { return poses_; }

 private:
  HalfPose last_;
  CellSet visited_;
  std::vector<Pose> poses_;
};

}  // namespace labmouse
