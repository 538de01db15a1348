// Board files: which pin of the chip is wired to which part of a robot. docs/reference/files.md has their keys.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/maze/formats/format.hpp"

namespace labmouse::avr {

/// A pin of an ATmega328P.
struct Pin {
  char port = 0;     ///< 'B', 'C' or 'D'; 0: it has no digital part, as A6 and A7
  int bit = 0;       ///< of that port
  int channel = -1;  ///< of the ADC; -1: none

  friend bool operator==(const Pin&, const Pin&) = default;
};

/// The pin of that name, as on an Arduino (D0 to D13, A0 to A7) or in the data sheet (PB5).
std::optional<Pin> find_pin(std::string_view name);

/// What a wheel is wired to.
struct Wheel {
  Pin pwm;                      ///< while it drives ahead, and backwards where there is no second one
  std::optional<Pin> back_pwm;  ///< while it drives backwards, where the driver has a PWM pin for each direction
  std::optional<Pin> direction;
  bool ahead_is_high = true;  ///< level of `direction` that drives ahead
  Pin a, b;                   ///< channels of its encoder
  bool is_clock = false;      ///< whether `a` has the exclusive or of both channels
  bool a_leads = true;        ///< whether edges of channel A come first while it turns ahead
};

/// An infrared sensor, in the order of the robot file.
struct Receiver {
  Pin pin;
  std::optional<Pin> emitter;  ///< none: always lit
  double scale = 1.0;          ///< counts of this ADC for a count of the robot file
  double ambient = 0.0;        ///< counts that are read in any case
};

/// A button, or a hand before a sensor: a pin that has another voltage for some time.
struct Press {
  Pin pin;
  int released = 0, pressed = 0;  ///< mV
  int at = 0, hold = 0;           ///< ms since the chip was switched on, or the mouse was carried
};

/// The contents of a board file.
struct Board {
  std::string chip = "atmega328p";
  int frequency = 16'000'000;   ///< Hz
  int supply = 5'000;           ///< mV
  std::array<Wheel, 2> wheels;  ///< left and right
  std::vector<Receiver> receivers;
  std::optional<Pin> battery;
  double divider = 1.0;  ///< voltage of the battery over that at its pin
  std::vector<Press> presses;
  std::optional<Pin> goal, fast;  ///< a rising edge says that word of the protocol
  bool carried_resets = true;     ///< whether the chip is reset when a hand has carried the mouse
};

/// A board, or what is wrong with its file.
struct BoardResult {
  Board board;
  std::vector<Problem> problems;
};

/// Reads a board file of at most 64 KiB.
BoardResult read_board(std::string_view text);

}  // namespace labmouse::avr
