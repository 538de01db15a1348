// Interface of an external controller: a mouse's whole program, from sensor readings to motor duties.
#pragma once

#include <cstdint>
#include <string_view>

#include "labmouse/contest/drive_record.hpp"
#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/hardware/sense.hpp"
#include "labmouse/mouse/action.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// What the program knows before the contest. The amount of noise is not included.
struct ControllerBriefing {
  Size size;
  Pose start;
  CellSet goals;
  const DriveModel& model;  ///< the robot and what it is built of
  const DriveRules& rules;
  MazeTime handling = 0;   ///< time to carry the mouse to the start
  std::uint64_t seed = 0;  ///< for random numbers of its own
};

/// What a program reports with its duties. The true position decides on runs; this is only the program's intent.
enum class ControllerWord : std::uint8_t {
  drive,    ///< nothing
  fast,     ///< the next run to begin is a speed run
  goal,     ///< ends this run after it has entered a goal; the way home follows
  carry,    ///< asks to be carried to the start by hand
  give_up,  ///< the contest is over
};

/// The program's output for one tick.
struct ControllerTick {
  static constexpr int full = 32767;

  std::int16_t left = 0;  ///< duty, in parts of `full`
  std::int16_t right = 0;
  ControllerWord word = ControllerWord::drive;

  /// The duties as shares of full duty, about -1 to 1.
  constexpr Drive drive() const {
    return {static_cast<float>(left) / static_cast<float>(full), static_cast<float>(right) / static_cast<float>(full)};
  }
  friend constexpr bool operator==(const ControllerTick&, const ControllerTick&) = default;
};

/// It must take time only from ticks and chance only from its seed, so that contests can be repeated exactly.
class ControllerCode {
 public:
  virtual ~ControllerCode() = default;

  /// Called each millisecond, the first time as the mouse stands at the start.
  /// @param sense the sensor readings of this tick.
  /// @return the duties until the next tick, and a word.
  virtual ControllerTick tick(const Sense& sense) = 0;
  /// The mouse was carried to the start, where it stands as in the beginning. The argument is true after a crash, and
  /// false if the program asked for it.
  virtual void carried(bool /*crashed*/) {}

  /// Why it gave up.
  virtual ForfeitReason reason() const { return ForfeitReason::gave_up; }
  /// See Strategy.
  virtual bool started() const { return true; }
  /// See StrategyReport; valid until the next call.
  virtual std::string_view last_words() { return {}; }
};

}  // namespace labmouse
