// An ATmega328P that runs a program in simavr, wired to a robot by a board.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "board.hpp"

namespace labmouse::avr {

/// What the robot's sensors read at a tick.
struct Readings {
  std::array<int, 2> edges{};  ///< counts of the encoders since the tick before; left, right
  std::vector<int> infrared;   ///< counts, in the order of the robot file
  int millivolts = 0;          ///< of the battery
};

/// What the pins say at the end of a tick.
struct Outputs {
  std::array<double, 2> duty{};     ///< of the left and the right motor, -1 to 1
  bool goal = false, fast = false;  ///< whether that pin has risen in this tick
};

/// The chip and the program in it.
class Chip {
 public:
  /// Loads a program for AVR from an ELF file. If that fails, `fault()` says why.
  Chip(const std::string& path, const Board& board);
  Chip(const Chip&) = delete;
  Chip& operator=(const Chip&) = delete;
  ~Chip();

  /// Runs it for a millisecond. The edges of the encoders are spread over it.
  Outputs tick(const Readings& readings);
  /// A hand has put the mouse at the start: the chip is reset, or its button pressed again.
  void carried();
  /// What ended the program, with the program counter; empty while it runs.
  const std::string& fault() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace labmouse::avr
