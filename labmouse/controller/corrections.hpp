// Corrects the pose estimate from the walls that the sensors see. Side walls give the lateral and heading error; the
// edges of walls, posts, and walls ahead give the longitudinal error.
#pragma once

#include <optional>
#include <vector>

#include "labmouse/controller/controller_choice.hpp"
#include "labmouse/controller/edge_finder.hpp"
#include "labmouse/controller/estimator.hpp"
#include "labmouse/controller/target.hpp"
#include "labmouse/controller/view.hpp"
#include "labmouse/mouse/knowledge.hpp"

namespace labmouse {

/// A row or column of cells that a mouse drives along.
struct Corridor {
  Cell cell;
  Heading axis = Heading::north;
};
/// The corridor along which the target moves, within 12 degrees; none in the middle of a turn.
std::optional<Corridor> corridor_of(const Target& target, double cell);

class Corrections {
 public:
  /// The hardware must outlive it.
  Corrections(const Hardware& hardware, double cell, Size size, const CorrectionChoice& choice);

  /// Corrects the estimator with one tick's readings. Readings that contradict the map `known` are ignored. Null: no
  /// map.
  void apply(const Sense& sense, const Target& target, const Knowledge* known, Estimator& estimator);
  void forget();
  const Views& views() const { return views_; }

 private:
  void see_side(std::size_t sensor, const Sense& sense, const Corridor& corridor, const Knowledge* known,
                Estimator& estimator);
  void see_wall(std::size_t sensor, double level, const View& view, const ViewSlopes& slopes,
                Estimator& estimator) const;
  void see_edge(const SeenEdge& seen, const View& view, const ViewSlopes& slopes, Cell behind, Heading side,
                Heading axis, const Knowledge* known, Estimator& estimator) const;
  void see_range(const RangerMount& mount, double distance, const Corridor& corridor, const Knowledge* known,
                 Estimator& estimator) const;
  Cell cell_along(const Corridor& corridor, double along) const;

  const Hardware& hardware_;
  double cell_;
  Size size_;
  CorrectionChoice choice_;
  Views views_;
  std::vector<EdgeFinder> finders_;  ///< of the infrared sensors
  std::vector<RangerMount> mounts_;  ///< of the ToF sensors
};

}  // namespace labmouse
