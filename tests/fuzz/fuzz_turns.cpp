// Any bytes as a table of turns: there are turns or a problem, and a robot fitted to them has a text that reads as a
// robot or says what speaks against it.
#include <cmath>

#include "labmouse/lab/robots/fitted_robot.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/lab/robots/turn_table.hpp"
#include "tests/fuzz/check_reader.hpp"

namespace {

using labmouse::fuzz::require;

void check_fit(const std::vector<labmouse::KnownTurn>& turns, const labmouse::Robot& base, double cell) {
  const labmouse::FittedRobot fitted = labmouse::fitted_robot(turns, base, cell);
  require(fitted.text.empty() != fitted.error.empty());
  if (!fitted.text.empty() && fitted.doubt.empty())
    require(labmouse::read_robot(fitted.text, "fitted").robot.has_value());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  // One with limits, and one with a table of times.
  static const labmouse::Robot limits = labmouse::find_robot("kerise").robot;
  static const labmouse::Robot times = labmouse::find_robot("mm2021").robot;
  const labmouse::TurnTable read = labmouse::read_turn_table({reinterpret_cast<const char*>(bytes), size});
  require(read.turns.empty() != read.problems.empty());
  require(read.problems.size() <= labmouse::most_problems);
  if (read.turns.empty()) return 0;
  for (const labmouse::KnownTurn& turn : read.turns)
    for (const double number : {turn.speed, turn.milliseconds, turn.aside, turn.before})
      require(std::isfinite(number) && number >= 0.0);
  const double known = labmouse::cell_of(read.turns);
  require(std::isfinite(known) && known >= 0.0);
  for (const labmouse::Robot* base : {&limits, &times}) check_fit(read.turns, *base, known > 0.0 ? known : base->cell);
  return 0;
}
