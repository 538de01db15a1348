// The driver in the physical world: it simulates body and controller tick by tick, and collects wall readings.
#pragma once

#include <cstdint>

#include "labmouse/contest/clocked_body.hpp"
#include "labmouse/contest/contest_driver.hpp"
#include "labmouse/contest/physical_conditions.hpp"
#include "labmouse/contest/physical_record.hpp"
#include "labmouse/controller/controller.hpp"

namespace labmouse {

class PhysicalDriver final : public ContestDriver {
 public:
  /// All must outlive it.
  PhysicalDriver(const Maze& maze, const DriveModel& model, const PhysicalConditions& conditions, std::uint64_t seed,
                 MazeTime time_limit, PhysicalRecord& record, const ControllerParts& parts);

  bool errs() const override { return true; }
  void put_at_start() override;
  void carry_to_start() override;
  void know_open(const WallSet& walls) override { walls_.know_open(clock(), walls); }
  void look_about() override;
  bool make(const Action& part, bool replanned) override;
  bool run(const DriveRoute& route) override;
  void set_pace(double pace) override { controller_.set_pace(usual_pace_ * pace); }

  const SearchPlace& place() const override { return controller_.place(); }
  const Knowledge& known() const override { return walls_.known(); }
  Sighting seen(const Pose& pose) const override { return walls_.sighting(pose); }
  BelievedWalls* weighed() override { return walls_.weighs() ? &walls_ : nullptr; }
  MazeTime clock() const override { return body_.clock(); }
  /// Nothing more is driven where a part has given up, too.
  bool out_of_time() const override { return body_.out_of_time() || parts_.reason() != ForfeitReason::none; }
  std::optional<RunEnd> crash() const override;

 private:
  /// Ticks until the controller has arrived; false after a crash, at the end of the time, or if a part gave up.
  bool drive_on();
  void read();
  bool tick();
  void note_gates();

  PhysicalRecord& record_;
  Pose start_;
  MazeTime handling_;
  double usual_pace_;
  BelievedWalls walls_;
  ClockedBody body_;
  ControllerParts parts_;
  Controller controller_;
  Drive drive_;
  WallSet in_its_way_;    ///< closed walls on the present way
  bool pending_ = false;  ///< whether the controller has processed the present tick
};

}  // namespace labmouse
