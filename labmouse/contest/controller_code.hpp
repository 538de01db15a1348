// The program of a mouse that is somebody else's: all of it, from what the sensors read to what the motors do.
#pragma once

#include <cstdint>
#include <string_view>

#include "labmouse/contest/drive_record.hpp"
#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/hardware/sense.hpp"
#include "labmouse/mouse/action.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// What it knows before the mouse is put into the maze. How much noise there is, nobody tells.
struct ControllerBriefing {
  Size size;
  Pose start;
  CellSet goals;
  const DriveModel& model;  ///< the robot and what it is built of
  const DriveRules& rules;
  MazeTime handling = 0;   ///< that it takes to carry the mouse to the start
  std::uint64_t seed = 0;  ///< for dice of its own
};

/// What a program says beside its duties. On runs the truth alone decides; this says what the mouse takes them for.
enum class ControllerWord : std::uint8_t {
  drive,    ///< nothing
  fast,     ///< the next run to begin is a fast one
  goal,     ///< this run is over, once it has been in a goal: what follows is the way home
  carry,    ///< a hand shall carry it to the start, and it does nothing more where it is
  give_up,  ///< the contest is over
};

/// What a program has its mouse do until the next tick.
struct ControllerTick {
  static constexpr int full = 32767;

  std::int16_t left = 0;  ///< duty, in parts of `full`
  std::int16_t right = 0;
  ControllerWord word = ControllerWord::drive;

  constexpr Drive drive() const {
    return {static_cast<float>(left) / static_cast<float>(full), static_cast<float>(right) / static_cast<float>(full)};
  }
  friend constexpr bool operator==(const ControllerTick&, const ControllerTick&) = default;
};

/// It has no clock but its ticks, and no dice but those of its seed, so that the same contest is the same again.
class ControllerCode {
 public:
  virtual ~ControllerCode() = default;

  /// Called each millisecond, the first time as the mouse stands at the start.
  virtual ControllerTick tick(const Sense& sense) = 0;
  /// A hand has carried it to the start, where it stands as in the beginning: after a crash, or because it wanted to.
  virtual void carried(bool /*crashed*/) {}

  /// Why it gave up.
  virtual ForfeitReason reason() const { return ForfeitReason::gave_up; }
  /// As of Strategy.
  virtual bool started() const { return true; }
  virtual std::string_view last_words() { return {}; }
};

}  // namespace labmouse
