#include "labmouse/lab/robots/robot_arrays.hpp"

#include <fmt/format.h>

#include <vector>

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
  // A path of free shape has no ramp and no yaw rate of its own: see curvature_text().
  const bool free = !shape.parts.empty();
  const double rate = free ? 0.0 : turn.speed * shape.ramp.peak * degrees;
  // A trapezoid without a limit of yaw jerk rises at this steady rate; of others it is the mean.
  const double acceleration = free ? 0.0 : rate * turn.speed / shape.ramp.length;
  return fmt::format("    {{{:.1f}f, {:.2f}f, {:.2f}f, {:.2f}f, {:.2f}f, {:.1f}f, {:.1f}f, {:.3f}f}},\n", turn.speed,
                     shape.lead_in, shape.lead_out, shape.length, shape.ramp.length, rate, acceleration,
                     static_cast<double>(turn.time) / 1e3);
}

/// The curvature along the curve of each speed of a turn of free shape; it is linear between these places.
std::string curvature_text(std::string_view name, const std::vector<const TurnShape*>& shapes) {
  std::string text;
  for (std::size_t speed = 0; speed < shapes.size(); ++speed) {
    text += fmt::format("static const float {}_curvature_{}[][2] = {{\n", name, speed);
    double begin = 0.0;
    for (const CurvePart& part : shapes[speed]->parts) {
      // With a limit of yaw jerk the curvature is no straight line.
      const int steps = part.bend == 0.0 ? 1 : 8;
      for (int i = 0; i <= steps; ++i) {
        const double place = part.length * i / steps;
        text += fmt::format("    {{{:.2f}f, {:.4f}f}},\n", begin + place, part.curvature_at(place) * 1e3);
      }
      begin += part.length;
    }
    text += "};\n";
  }
  return text;
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
  if (robot.profile == TurnProfile::free)
    text +=
        "/* Turns whose ramp is 0 have a free path: pairs of mm along the curve and curvature in rad/m are in an array "
        "for\n"
        "   each speed, the first speed in TURN_curvature_0. */\n";
  std::vector<const TurnShape*> free;
  const auto end_of_turn = [&](Turn turn) {
    text += "};\n";
    if (!free.empty()) text += curvature_text(names.of[static_cast<unsigned>(turn)], free);
    free.clear();
  };
  Turn last = Turn::out135;  // not shown
  for (const std::size_t i : shown_turns(model)) {
    const DrivenTurn& turn = model.tables.turns[i];
    if (turn.turn != last) {
      if (last != Turn::out135) end_of_turn(last);
      text += fmt::format("static const struct labmouse_turn {}[] = {{\n", names.of[static_cast<unsigned>(turn.turn)]);
    }
    last = turn.turn;
    text += turn_text(turn, model.shapes[i]);
    if (!model.shapes[i].parts.empty()) free.push_back(&model.shapes[i]);
  }
  if (last != Turn::out135) end_of_turn(last);
  text += straight_text("straight", robot.speed, robot.acceleration, robot.braking);
  if (robot.diagonals)
    text += straight_text("diagonal", robot.speed_diagonal, robot.acceleration_diagonal, robot.braking_diagonal);
  return text;
}

}  // namespace labmouse
