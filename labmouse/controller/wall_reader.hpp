// Detects the walls around a cell from the readings, and allows for the uncertainty of the pose.
//
// Method: each infrared sensor's readings are averaged over the stretch where it should meet the wall and no post. The
// likelihoods of that mean with and without the wall are summed over possible positions near the estimate. So a mouse
// that may be off by a post's width does not take a post for a wall.
#pragma once

#include <optional>
#include <vector>

#include "labmouse/controller/parts.hpp"
#include "labmouse/controller/view.hpp"
#include "labmouse/mouse/evidence.hpp"
#include "labmouse/mouse/pose.hpp"

namespace labmouse {

class WallReader final : public ReaderPart {
 public:
  /// The hardware must outlive it.
  WallReader(const Hardware& hardware, double cell);

  void begin(const Pose& pose) override;
  void read(const Sense& sense, const PoseEstimate& estimate) override;
  WallEvidence evidence(const PoseEstimate& estimate) const override;

 private:
  /// What a sensor looks at: the wall line on a side of the cell, and the coordinate on it where the cell begins.
  struct Sight {
    WallLine line;
    double begin = 0.0;
  };
  /// Sums over an infrared sensor's readings of a sight.
  struct Stretch {
    int count = 0;
    double level = 0.0, expected = 0.0, along = 0.0;  ///< sums: read, expected of a whole wall, mm from `begin`
    View view;                                        ///< the last view, and the mouse's direction then
    Direction ahead;
  };

  void read_infrared(std::size_t sensor, const Sense& sense, const PoseEstimate& estimate);
  void read_range(std::size_t sensor, const RangeSense& seen, const PoseEstimate& estimate);
  bool passes_middle(std::size_t sensor, double distance, const PoseEstimate& estimate) const;
  Sight sight_of(BeamSide side, const Pose& pose) const;
  double nats_of(std::size_t sensor, const PoseEstimate& estimate) const;
  double likelihood(double level, double expected) const;
  double post_share(double along, double deviation) const;

  const Hardware& hardware_;
  double cell_;
  Views views_;
  std::optional<Pose> pose_;
  std::vector<Sight> sights_;        ///< of the infrared sensors
  std::vector<Stretch> stretches_;   ///< of the infrared sensors
  std::vector<RangerMount> mounts_;  ///< of the ToF sensors
  std::vector<double> ranged_;       ///< log-odds of a wall by each ToF sensor, nats
};

}  // namespace labmouse
