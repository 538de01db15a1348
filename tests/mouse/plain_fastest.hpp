// Fastest routes the plain way: what the planner of the world in seconds is tested and measured against.
#pragma once

#include <vector>

#include "labmouse/grid/wall_set.hpp"
#include "labmouse/mouse/pose.hpp"
#include "labmouse/mouse/robot/tables.hpp"

namespace labmouse::test {

/// All times to the goals, by the algorithm of Dijkstra (1959) with a queue of the standard library. It knows no cells
/// and no nodes but points on a lattice of half cells and eight directions, and a turn as the points that it passes.
class PlainFastest {
 public:
  PlainFastest(Size size, const DriveTables& tables, const WallSet& passages, const CellSet& goals);

  /// As FastestRoutes gives them.
  DriveTime rolling(const DriveNode& node, std::size_t lane) const;
  DriveTime time_from(Pose start) const;
  /// Whether a turn can end at a node in that lane.
  bool turn_ends(const DriveNode& node, std::size_t lane) const;

 private:
  struct Spot {
    HalfPoint point;
    int direction = 0;  ///< in eighths of a turn clockwise from north
  };
  /// A turn in one place: it may be driven, and leads from spot to spot.
  struct DrivenPlace {
    Spot from;
    Spot to;
    Turn turn;
  };

  bool passable(HalfPoint point) const;
  int room_behind(HalfPoint goal, int direction) const;
  void find_places();
  void add_turn(Turn turn, Spot from, int side);
  void add_diagonal_turn(Spot from, int side);
  void settle();
  void reach(std::size_t label, DriveTime time);
  void begin_at_goals();
  void before_straight(Spot spot, std::size_t lane, DriveTime time);
  void before_turn(Spot spot, std::size_t lane, DriveTime time);
  const StraightTimes& straights(int direction) const { return direction % 2 == 0 ? tables_.along : tables_.diagonal; }
  std::size_t label(Spot spot, bool turning, std::size_t lane) const;

  Size size_;
  const DriveTables& tables_;
  const WallSet& passages_;
  const CellSet& goals_;
  std::size_t lanes_;
  std::vector<std::vector<DrivenPlace>> ending_;  ///< the turns that end in each spot
  std::vector<DriveTime> times_;                  ///< by label
  std::vector<std::pair<DriveTime, std::size_t>> queue_;
};

}  // namespace labmouse::test
