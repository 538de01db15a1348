// The wall map of a mouse in a contest. It is updated by readings, and writes each change into the record.
#pragma once

#include <array>
#include <cstdint>

#include "labmouse/contest/physical_record.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/log_odds_map.hpp"
#include "labmouse/mouse/sighting.hpp"

namespace labmouse {

class BelievedWalls {
 public:
  /// Maze and record must outlive it.
  BelievedWalls(const Maze& maze, MapKind map, PhysicalRecord& record);

  /// Adds the readings of a pose: an unknown wall gets its more likely state; for a known wall, the map kind decides
  /// whether evidence is combined or contradictions are only counted.
  void read(MazeTime time, const Pose& pose, const WallEvidence& evidence);
  /// The mouse came straight from there, in its present heading: marks the walls on the way as surely open.
  void pass(MazeTime time, Cell from, const Pose& to);
  /// Marks walls as surely open.
  void know_open(MazeTime time, const WallSet& walls);
  /// The mouse crashed on its way through that passage. From now on its wall counts as closed, whatever readings say,
  /// until no route is left. A passage through which the mouse has driven before stays open.
  void close_after_crash(MazeTime time, Wall wall);
  /// Halves the weight of the last readings, because they may be of other walls.
  void weaken_last();
  /// The mouse was put down elsewhere: later readings are independent of the last ones.
  void put_down() {
    last_evidence_ = {};
    against_ = {};
  }
  void forget_all();
  /// See LogOddsMap::weaken_path().
  bool weaken_path(Cell from, const CellSet& to) {
    closed_by_crash_ = {};
    return log_odds_.weaken_path(from, to);
  }

  Size size() const { return maze_.size(); }
  /// Whether the believed position must be wrong: three sure readings in the last two cells contradicted the map. Only
  /// true with MapKind::learned.
  bool doubts_its_place() const { return asks_where_it_is_ && against_[0] + against_[1] >= 3; }
  /// Whether the map combines contradicting readings, rather than keep the first.
  bool weighs() const { return weighs_; }
  const Knowledge& known() const { return log_odds_.view(); }
  const LogOddsMap& log_odds() const { return log_odds_; }
  Sighting sighting(const Pose& pose) const { return log_odds_.sighting(pose); }
  /// The given walls that are closed in the true maze.
  WallSet standing(const WallSet& walls) const;

 private:
  /// A reading that weaken_last() can weaken.
  struct Reading {
    Wall wall;
    int evidence = 0;
  };

  void take(MazeTime time, Cell cell, Heading side, Evidence evidence);
  /// Adds evidence, which weaken_last() can weaken.
  LogOddsMap::News add(MazeTime time, Wall wall, int evidence);
  LogOddsMap::News add_to_map(MazeTime time, Wall wall, int evidence);
  void note(MazeTime time, Wall wall);

  const Maze& maze_;
  PhysicalRecord& record_;
  LogOddsMap log_odds_;
  bool weighs_, asks_where_it_is_;
  WallSet passed_, closed_by_crash_;
  std::array<Reading, 12> last_evidence_{};  ///< ring buffer of the last readings
  std::size_t evidence_count_ = 0;
  std::array<int, 2> against_{};  ///< sure readings that contradicted the map, in the last cell and the one before
};

}  // namespace labmouse
