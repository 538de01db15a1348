// Any bytes as a table of turns: there are turns or a problem, and a robot fitted to them has a text that reads as a
// robot or says what speaks against it.
#include <cmath>

#include "labmouse/lab/robots/fitted_robot.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/lab/robots/turn_table.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

namespace {

void check_fit(const std::vector<KnownTurn>& turns, const Robot& base, double cell) {
  const FittedRobot fitted = fitted_robot(turns, base, cell);
  require(fitted.text.empty() != fitted.error.empty());
  if (!fitted.text.empty() && fitted.doubt.empty()) require(read_robot(fitted.text, "fitted").robot.has_value());
}

}  // namespace

LABMOUSE_FUZZER(turns) {
  // One with limits, and one with a table of times.
  static const Robot limits = find_robot("kerise").robot;
  static const Robot times = find_robot("mm2021").robot;
  const TurnTable read = read_turn_table({reinterpret_cast<const char*>(bytes), size});
  require(read.turns.empty() != read.problems.empty());
  require(read.problems.size() <= most_problems);
  if (read.turns.empty()) return 0;
  for (const KnownTurn& turn : read.turns)
    for (const double number : {turn.speed, turn.milliseconds, turn.aside, turn.before})
      require(std::isfinite(number) && number >= 0.0);
  const double known = cell_of(read.turns);
  require(std::isfinite(known) && known >= 0.0);
  for (const Robot* base : {&limits, &times}) check_fit(read.turns, *base, known > 0.0 ? known : base->cell);
  return 0;
}

}  // namespace labmouse::fuzz
