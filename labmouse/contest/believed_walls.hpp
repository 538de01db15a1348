// What a mouse in a contest takes walls for: readings come in, and the record learns what they changed.
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

  /// Takes what the evidence is rather for as the state of walls that it does not know, and weighs it with what it
  /// knows of others.
  void read(MazeTime time, const Pose& pose, const WallEvidence& evidence);
  /// The mouse has come from there, straight on in the heading in which it is: the walls on its way are surely open.
  void pass(MazeTime time, Cell from, const Pose& to);
  /// Counts the last readings by half: they may be of other walls.
  void weaken_last();
  /// What is read from now on has nothing to do with the last readings.
  void put_down() {
    last_evidence_ = {};
    against_ = {};
  }
  void forget_all();
  /// LogOddsMap::weaken_path().
  bool weaken_path(Cell from, const CellSet& to) { return log_odds_.weaken_path(from, to); }

  Size size() const { return maze_.size(); }
  /// Whether it must be somewhere else: in its last two cells three sure readings spoke against its map. Only a learned
  /// map asks.
  bool doubts_its_place() const { return asks_where_it_is_ && against_[0] + against_[1] >= 3; }
  /// Whether its map weighs readings.
  bool weighs() const { return weighs_; }
  const Knowledge& known() const { return log_odds_.view(); }
  const LogOddsMap& log_odds() const { return log_odds_; }
  Sighting sighting(const Pose& pose) const { return log_odds_.sighting(pose); }
  /// Of these walls those that stand.
  WallSet standing(const WallSet& walls) const;

 private:
  /// A reading, to be taken back.
  struct Reading {
    Wall wall;
    int evidence = 0;
  };

  void take(MazeTime time, Cell cell, Heading side, Evidence evidence);
  LogOddsMap::News add(MazeTime time, Wall wall, int evidence);
  void note(MazeTime time, Wall wall);

  const Maze& maze_;
  PhysicalRecord& record_;
  LogOddsMap log_odds_;
  bool weighs_, asks_where_it_is_;
  std::array<Reading, 12> last_evidence_{};  ///< the last readings, in turn
  std::size_t evidence_count_ = 0;
  std::array<int, 2> against_{};  ///< sure readings against its map, in the last cell and the one before
};

}  // namespace labmouse
