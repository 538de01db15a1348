#include "labmouse/lab/robots/robot_arrays.hpp"

#include <fmt/format.h>

#include "labmouse/lab/robots/robot_table.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

// Those of UKMARS and kerikun11 are assumed from their use in articles and repositories; the sources of a mouse that
// uses them would settle it.
constexpr std::array names_in_order = {
    TurnNames{"plain", {"TURN_45", "TURN_90", "TURN_135", "TURN_180", "TURN_V90", "TURN_S90", "", ""}},
    TurnNames{"ukmars", {"SD45", "SS90", "SD135", "SS180", "DD90", "SS90E", "", ""}},
    TurnNames{"kerikun11", {"F45", "F90", "F135", "F180", "FV90", "S90", "", ""}},
};

constexpr double degrees = 180.0 / 3.141592653589793;

std::string turn_text(const DrivenTurn& turn, const TurnShape& shape) {
  const double rate = turn.speed * shape.ramp.peak * degrees;
  // A trapezoid without a limit of yaw jerk rises at this steady rate; of others it is the mean.
  const double acceleration = rate * turn.speed / shape.ramp.length;
  return fmt::format("    {{{:.1f}f, {:.2f}f, {:.2f}f, {:.2f}f, {:.2f}f, {:.1f}f, {:.1f}f, {:.3f}f}},\n", turn.speed,
                     shape.lead_in, shape.lead_out, shape.length, shape.ramp.length, rate, acceleration,
                     static_cast<double>(turn.time) / 1e3);
}

std::string straight_text(std::string_view name, double speed, double acceleration, double braking) {
  return fmt::format("static const struct labmouse_straight {} = {{{:.1f}f, {:.1f}f, {:.1f}f}};\n", name, speed,
                     acceleration, braking);
}

/// The name in a comment: it comes from a file, and must not end the comment.
std::string in_comment(std::string_view name) {
  std::string text = shown(name);
  for (char& letter : text)
    if (letter == '*' || letter == '\\') letter = '_';
  return text;
}

}  // namespace

std::span<const TurnNames> all_turn_names() { return names_in_order; }

std::string robot_arrays(const Robot& robot, const DriveModel& model, const TurnNames& names) {
  std::string text = fmt::format(
      "/* {}: cells of {:g} mm. Turns to the left; those to the right are mirrored, and those from a diagonal to an\n"
      "   axis are driven backwards. A curve is a ramp of the yaw rate{}, an arc, and the same ramp down. */\n"
      "struct labmouse_turn {{\n"
      "    float speed;            /* mm/s */\n"
      "    float lead_in;          /* mm straight on before the curve */\n"
      "    float lead_out;         /* mm straight on after it */\n"
      "    float curve;            /* mm, with both ramps */\n"
      "    float ramp;             /* mm of one ramp */\n"
      "    float yaw_rate;         /* deg/s in the arc */\n"
      "    float yaw_acceleration; /* deg/s^2 in a ramp, its mean */\n"
      "    float time;             /* ms in the curve */\n"
      "}};\n"
      "struct labmouse_straight {{\n"
      "    float speed;        /* mm/s, the highest */\n"
      "    float acceleration; /* mm/s^2 */\n"
      "    float braking;      /* mm/s^2 */\n"
      "}};\n",
      in_comment(robot.name), robot.cell,
      robot.profile == TurnProfile{} ? "" : fmt::format(" (a {})", name_of(robot.profile)));
  Turn last = Turn::out135;  // not shown
  for (const std::size_t i : shown_turns(model)) {
    const DrivenTurn& turn = model.tables.turns[i];
    if (turn.turn != last)
      text += fmt::format("{}static const struct labmouse_turn {}[] = {{\n", last == Turn::out135 ? "" : "};\n",
                          names.of[static_cast<unsigned>(turn.turn)]);
    last = turn.turn;
    text += turn_text(turn, model.shapes[i]);
  }
  if (last != Turn::out135) text += "};\n";
  text += straight_text("straight", robot.speed, robot.acceleration, robot.braking);
  if (robot.diagonals)
    text += straight_text("diagonal", robot.speed_diagonal, robot.acceleration_diagonal, robot.braking_diagonal);
  return text;
}

}  // namespace labmouse
