// The moving part of a contest in the physical world: body and pilot, tick by tick, their clock, and what was read.
#pragma once

#include <cstdint>

#include "labmouse/contest/clocked_body.hpp"
#include "labmouse/contest/contest_driver.hpp"
#include "labmouse/contest/physical_conditions.hpp"
#include "labmouse/contest/physical_record.hpp"
#include "labmouse/pilot/pilot.hpp"

namespace labmouse {

class PhysicalDriver final : public ContestDriver {
 public:
  /// All must outlive it.
  PhysicalDriver(const Maze& maze, const DriveModel& model, const PhysicalConditions& conditions, std::uint64_t seed,
                 MazeTime time_limit, PhysicalRecord& record, const PilotParts& parts);

  void put_at_start() override;
  void look_about() override;
  bool make(const Action& part, bool replanned) override;
  bool run(const DriveRoute& route) override;
  void wait(MazeTime time) override { body_.wait(time); }
  void set_pace(double pace) override { pilot_.set_pace(pace); }

  const SearchPlace& place() const override { return pilot_.place(); }
  BelievedWalls& walls() override { return walls_; }
  MazeTime clock() const override { return body_.clock(); }
  bool out_of_time() const override { return body_.out_of_time(); }
  bool crashed() const override { return body_.crashed(); }
  RunEnd cause() const override;

 private:
  /// Until the pilot has arrived; false where a crash or the end of the time came before.
  bool drive_on();
  void read();
  bool tick();
  void note_gates();

  PhysicalRecord& record_;
  Pose start_;
  BelievedWalls walls_;
  Hardware told_;  ///< what the pilot takes itself for
  ClockedBody body_;
  Pilot pilot_;
  Drive drive_;
  WallSet in_its_way_;    ///< walls that stand on the present way
  bool pending_ = false;  ///< whether the pilot has worked off the present tick
};

}  // namespace labmouse
