#include "labmouse/lab/robots/robot_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/robots/robot_remarks.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// The time in milliseconds, with decimals only where needed: "300 ms", "295.54 ms".
std::string milliseconds_text(DriveTime time) { return fmt::format("{} ms", time / 1e3); }

/// A line for one turn. A robot with given times has no shapes, only speeds and times.
std::string turn_line(const Robot& robot, const DrivenTurn& turn, const TurnShape& shape, bool first) {
  std::string line =
      fmt::format("{:<5} {:>7.1f} {:>8.3f}", first ? name_of(turn.turn) : "", turn.speed, turn.time / 1e3);
  if (!robot.fixed)
    line += fmt::format(" {:>8.1f} {:>8.1f} {:>8.1f} {:>9.1f}", shape.lead_in, shape.lead_out, shape.length,
                        shape.clearance);
  return line + "\n";
}

std::string turns_text(const Robot& robot, const DriveModel& model) {
  std::string text = fmt::format("{:<5} {:>7} {:>8}", "turn", "mm/s", "ms");
  if (!robot.fixed) text += fmt::format(" {:>8} {:>8} {:>8} {:>9}", "lead in", "lead out", "curve mm", "clearance");
  text += "\n";
  for (const std::size_t i : shown_turns(model)) {
    const DrivenTurn& turn = model.tables.turns[i];
    const bool first = i == 0 || model.tables.turns[i - 1].turn != turn.turn;
    text += turn_line(robot, turn, model.shapes[i], first);
  }
  return text;
}

std::string straight_line(std::string_view name, double speed, double acceleration, double braking) {
  return fmt::format("{:<9} {:g} mm/s, {:g} mm/s² up, {:g} mm/s² down\n", name, speed, acceleration, braking);
}

std::string grip_line(const Robot& robot) {
  if (robot.grip <= 0.0) return "";
  return fmt::format("{:<9} {:g} mm/s² in all directions: in turns the speed may change, to any of those above\n",
                     "grip", robot.grip);
}

std::string profile_line(const Robot& robot) {
  if (robot.profile == TurnProfile{}) return "";
  return fmt::format("{:<9} {}: how the yaw rate of a turn rises and falls\n", "profile", name_of(robot.profile));
}

std::string ends_line(const Robot& robot) {
  if (robot.fixed)
    return fmt::format("{:<9} {:g} mm/s, also at the start and the end; turns lead from node to node\n", "nodes",
                       robot.fixed->speed);
  return fmt::format(
      "{:<9} at rest, {:g} mm behind the middle of the start cell\n{:<9} {}\n", "start", robot.run_up, "goal",
      robot.stop == Stop::goal ? "slow enough to stop in the last open cell straight behind it" : "at any speed");
}

std::string search_line(const SearchDrive& search) {
  std::string lines =
      fmt::format("{:<9} cell {}, turn {}, back {}, quarter on the spot {}, half a cell from rest {}\n", "search",
                  milliseconds_text(search.cell), milliseconds_text(search.turn), milliseconds_text(search.back),
                  milliseconds_text(search.quarter), milliseconds_text(search.half_cell));
  if (search.dashes())
    lines += fmt::format("{:<9} 2 known cells {}, 4 {}, 8 {}\n", "dashes", milliseconds_text(search.dash(2)),
                         milliseconds_text(search.dash(4)), milliseconds_text(search.dash(8)));
  return lines;
}

std::string remark_lines(const Robot& robot, const DriveModel& model) {
  std::string lines;
  for (const std::string& remark : robot_remarks(robot, model)) lines += fmt::format("{:<9} {}\n", "remark", remark);
  return lines;
}

}  // namespace

std::vector<std::size_t> shown_turns(const DriveModel& model) {
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < model.shapes.size(); ++i) {
    const DrivenTurn& turn = model.tables.turns[i];
    if ((begins_diagonal(turn.turn) && !ends_diagonal(turn.turn)) || turn.end_speed != turn.speed) continue;
    shown.push_back(i);
  }
  return shown;
}

std::string hash_words(const DriveTables& tables) { return fmt::format("{:016x}", tables.hash); }

std::string robot_table(const Robot& robot, const DriveModel& model) {
  return fmt::format("{}: cells of {:g} mm, sees {} cell{} far\n", shown(robot.name), robot.cell, robot.sight,
                     robot.sight == 1 ? "" : "s") +
         turns_text(robot, model) + straight_line("straight", robot.speed, robot.acceleration, robot.braking) +
         (robot.diagonals
              ? straight_line("diagonal", robot.speed_diagonal, robot.acceleration_diagonal, robot.braking_diagonal)
              : fmt::format("{:<9} none\n", "diagonal")) +
         profile_line(robot) + grip_line(robot) + ends_line(robot) + search_line(model.search) +
         fmt::format("{:<9} {}\n", "tables", hash_words(model.tables)) + remark_lines(robot, model);
}

std::string robot_line(const Robot& robot, const DriveModel& model) {
  if (robot.fixed)
    return fmt::format("cells of {:g} mm, straights up to {:g} mm/s, {:g} mm/s between turns of given times",
                       robot.cell, robot.speed, robot.fixed->speed);
  const auto [slowest, fastest] =
      std::minmax_element(model.tables.turns.begin(), model.tables.turns.end(),
                          [](const DrivenTurn& a, const DrivenTurn& b) { return a.speed < b.speed; });
  return fmt::format("cells of {:g} mm, straights up to {:g} mm/s, turns at {:.0f} to {:.0f} mm/s", robot.cell,
                     robot.speed, slowest->speed, fastest->speed);
}

}  // namespace labmouse
