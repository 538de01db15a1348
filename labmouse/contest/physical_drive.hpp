// The moving part of a contest in the physical world: body and pilot, tick by tick, their clock, and what was read.
#pragma once

#include <array>
#include <cstdint>

#include "labmouse/contest/clocked_body.hpp"
#include "labmouse/contest/physical_conditions.hpp"
#include "labmouse/contest/physical_record.hpp"
#include "labmouse/mouse/belief.hpp"
#include "labmouse/mouse/sighting.hpp"
#include "labmouse/pilot/pilot.hpp"

namespace labmouse {

/// Drives, and writes what happens into the record, whose last run it is part of.
class PhysicalDriver {
 public:
  /// All must outlive it.
  PhysicalDriver(const Maze& maze, const DriveModel& model, const PhysicalConditions& conditions, std::uint64_t seed,
                 MazeTime time_limit, PhysicalRecord& record, const PilotParts& parts);

  /// A hand puts it at the start; it then looks about, by drive_on() and read().
  void put_at_start();
  /// A move of a search over one edge, a dash, or to rest; false where the run broke off.
  bool make(const Action& part, bool replanned);
  /// A fast run from the start, and until the mouse stands; false where it broke off.
  bool run(const DriveRoute& route);
  /// Until the pilot has arrived; false where a crash or the end of the time came before.
  bool drive_on();
  /// Takes what the evidence is rather for as the state of walls that it does not know.
  void read();
  void wait(MazeTime time) { body_.wait(time); }

  /// Where the mouse believes to be, between two moves, and what it takes the walls there for.
  const SearchPlace& place() const { return pilot_.place(); }
  Sighting sighting(const Pose& pose) const;
  const Knowledge& known() const { return belief_.view(); }
  const Belief& belief() const { return belief_; }
  /// Counts the last readings by half: they may be of other walls.
  void doubt_last();
  /// Belief::doubt_way().
  bool doubt_way(Cell from, const CellSet& to) { return belief_.doubt_way(from, to); }
  MazeTime clock() const { return body_.clock(); }
  bool out_of_time() const { return body_.out_of_time(); }
  bool crashed() const { return body_.crashed(); }
  /// Of a crash.
  RunEnd cause() const;

 private:
  /// A reading, to be taken back.
  struct Told {
    Wall wall;
    int evidence = 0;
  };

  bool tick();
  void note_gates();
  void pass(const Pose& from);
  void add(Wall wall, int evidence);
  void note(Wall wall);
  void take(Cell cell, Heading side, Evidence evidence);

  const Maze& maze_;
  PhysicalRecord& record_;
  Pose start_;
  Belief belief_;
  bool weighs_;                       ///< whether its map does
  std::array<Told, 12> told_last_{};  ///< the last readings, in turn
  std::size_t told_count_ = 0;
  Hardware told_;  ///< what the pilot takes itself for
  ClockedBody body_;
  Pilot pilot_;
  Drive drive_;
  bool pending_ = false;  ///< whether the pilot has worked off the present tick
};

}  // namespace labmouse
