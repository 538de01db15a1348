// Whether walls stand about a cell: what readings say, weighed by how sure a mouse is of its place.
//
// Method: over a stretch each beam's readings are averaged, where it should meet the wall and no post. How likely that
// mean is with the wall, and without it, is summed over places at which the mouse may be, near where it believes to be:
// a mouse that may be off by a post's width does not take a post for a wall.
#pragma once

#include <array>
#include <optional>

#include "labmouse/mouse/pose.hpp"
#include "labmouse/pilot/estimator.hpp"
#include "labmouse/pilot/evidence.hpp"
#include "labmouse/pilot/view.hpp"

namespace labmouse {

class WallReader {
 public:
  /// The hardware must outlive it.
  WallReader(const Hardware& hardware, double cell);

  /// Reads that cell from now on, as seen in that heading.
  void begin(const Pose& pose);
  /// One tick.
  void read(const Sense& sense, const Estimator& estimator);
  /// What was read so far.
  WallEvidence evidence(const Estimator& estimator) const;

 private:
  /// What a beam looks at: the line on a side of the cell, and where on it the cell begins.
  struct Sight {
    Heading side = Heading::north;
    WallLine line;
    double begin = 0.0;
  };
  /// A beam's readings of it.
  struct Stretch {
    int count = 0;
    double level = 0.0, expected = 0.0, along = 0.0;  ///< sums: read, of a whole wall, and where behind the beginning
    View view;                                        ///< the last one, and where the mouse pointed then
    Direction ahead;
  };

  void read_beam(std::size_t beam, const Sense& sense, const Estimator& estimator);
  void read_range(const Sense& sense, const Estimator& estimator);
  Sight sight_of(std::size_t beam, const Pose& pose) const;
  double nats_of(std::size_t beam, const Estimator& estimator) const;
  double likelihood(double level, double expected) const;
  double post_share(double along, double cosine) const;

  const Hardware& hardware_;
  double cell_;
  Views views_;
  std::optional<Pose> pose_;
  std::array<Sight, beam_count> sights_;
  std::array<Stretch, beam_count> stretches_;
  WallLine front_;
  double ranged_ = 0.0;  ///< what the ranger says: nats for a wall ahead
};

}  // namespace labmouse
