#include "labmouse/lab/pictures/robot_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "labmouse/lab/drawing/legend.hpp"
#include "labmouse/lab/drawing/palette.hpp"
#include "labmouse/lab/drawing/plot_area.hpp"
#include "labmouse/lab/drawing/sheet.hpp"
#include "labmouse/mouse/robot/turn_room.hpp"

namespace labmouse {
namespace {

using namespace drawing;

// In pixels. A panel shows 2×2 cells, enough for every turn, and its figures below.
constexpr int cell = 96, panel_width = 3 * cell, margin = 32, top = 64, columns = 3, line_height = 19;
constexpr std::array drawn_turns = {Turn::f45, Turn::f90, Turn::f135, Turn::f180, Turn::v90, Turn::s90};
constexpr int right = 2 * margin + columns * panel_width - margin;

/// Given times need one line of figures, turns computed from limits need four.
int panel_height(const Robot& robot) { return 2 * cell + 48 + (robot.fixed ? 1 : 4) * line_height; }

/// The turns of one kind, the fastest first, with their shape and its place in the picture.
struct Panel {
  std::vector<DrivenTurn> turns;
  TurnShape shape;
  TurnRoom room;
  Point corner;  ///< the north-west post of the cells
};

/// The panel of a turn; its corner is not set yet.
Panel panel_of(const DriveModel& model, Turn turn) {
  Panel panel;
  panel.room = room_of(turn);
  for (std::size_t i = 0; i < model.shapes.size(); ++i)
    if (model.shapes[i].turn == turn) {
      panel.turns.push_back(model.tables.turns[i]);
      panel.shape = model.shapes[i];
    }
  return panel;
}

/// The panels, row by row. A robot without diagonals has only some of the turns.
std::vector<Panel> panels_of(const Robot& robot, const DriveModel& model) {
  std::vector<Panel> panels;
  for (const Turn turn : drawn_turns) {
    Panel panel = panel_of(model, turn);
    if (panel.turns.empty()) continue;
    const int number = static_cast<int>(panels.size());
    panel.corner = {margin + number % columns * panel_width + cell / 2, top + number / columns * panel_height(robot)};
    panels.push_back(std::move(panel));
  }
  return panels;
}

/// The south-western of the 2×2 cells; the turn begins in the south-eastern one or on its northern side.
Cell south_west(const Panel& panel) { return neighbour(panel.room.from.cell, Heading::west); }

std::string place(const Panel& panel, MazePoint point) {
  const Cell corner = south_west(panel);
  return fmt::format("{:.1f} {:.1f}", panel.corner.x + (point.x - corner.x) * cell,
                     panel.corner.y + (corner.y + 2 - point.y) * cell);
}

/// Path data of a wall; empty if it is outside of the panel.
std::string wall_path(const Panel& panel, Wall wall) {
  const Cell corner = south_west(panel);
  const bool level = wall.side == Heading::north;
  const int x = wall.cell.x + 1 - (level ? 1 : 0) - corner.x;
  const int y = wall.cell.y + 1 - corner.y;
  if (x < 0 || x > (level ? 1 : 2) || y < (level ? 0 : 1) || y > 2) return "";
  return fmt::format("M{} {}{}{}", panel.corner.x + x * cell, panel.corner.y + (2 - y) * cell, level ? 'h' : 'v', cell);
}

std::string walls_path(const Panel& panel, const std::vector<Wall>& walls) {
  std::string path;
  for (const Wall wall : walls) path += wall_path(panel, wall);
  return path;
}

std::string posts_path(const Panel& panel) {
  std::string path;
  for (int y = 0; y <= 2; ++y)
    for (int x = 0; x <= 2; ++x) path += fmt::format("M{} {}h0", panel.corner.x + x * cell, panel.corner.y + y * cell);
  return path;
}

/// Path data of the turn between two distances along it, in mm.
std::string driven_path(const Panel& panel, double cell_side, double from, double to) {
  constexpr int pieces = 24;
  std::string path;
  for (int i = 0; i <= pieces; ++i) {
    const PathPoint point = panel.shape.at(from + (to - from) * i / pieces);
    path += (i == 0 ? "M" : "L") + place(panel, maze_point(panel.room.from, true, point, cell_side));
  }
  return path;
}

std::string path_svg(const Tone& tone, double width, std::string_view path) {
  return fmt::format("<path {} stroke-width=\"{:.1f}\" stroke-linejoin=\"round\" d=\"{}\"/>\n", stroke(tone), width,
                     path);
}

std::string open_wall(std::string_view path) {
  return fmt::format("<path {} stroke-width=\"2\" stroke-dasharray=\"4 4\" d=\"{}\"/>\n", stroke(faint), path);
}

std::string wall(const Tone& tone, std::string_view path) {
  return fmt::format("<path {} stroke-width=\"6\" stroke-linecap=\"square\" d=\"{}\"/>\n", stroke(tone), path);
}

std::string ends_svg(const Panel& panel) {
  const auto at = [&](const DriveNode& node) {
    const HalfPoint point = half_point(node);
    return place(panel, {point.x / 2.0, point.y / 2.0});
  };
  return fmt::format(
      "<g {}><circle r=\"5\" transform=\"translate({})\"/>"
      "<path d=\"M0 -9L7 6L-7 6Z\" transform=\"translate({}) rotate({})\"/></g>\n",
      fill(route), at(panel.room.from), at(panel.room.to), 45 * eighths(panel.room.to));
}

std::string drawing_of(const Panel& panel, const Robot& robot) {
  const TurnShape& shape = panel.shape;
  const auto path = [&](double from, double to) { return driven_path(panel, robot.cell, from, to); };
  // A given time includes the leads.
  const double begin = robot.fixed ? 0.0 : shape.lead_in;
  const double end = robot.fixed ? shape.whole() : shape.lead_in + shape.length;
  std::string svg;
  if (robot.clearance > 0.0)
    svg += path_svg(heat_tones[0], 2.0 * robot.clearance / robot.cell * cell, path(0.0, shape.whole()));
  svg += open_wall(walls_path(panel, panel.room.open)) + wall(ink, walls_path(panel, panel.room.standing)) +
         wall(post, posts_path(panel));
  if (begin > 0.0) svg += path_svg(onwards, 3, path(0.0, begin));
  if (end < shape.whole()) svg += path_svg(onwards, 3, path(end, shape.whole()));
  return svg + path_svg(route, 3, path(begin, end)) + ends_svg(panel);
}

std::vector<std::string> figures(const Panel& panel, const Robot& robot) {
  const auto driven = [](const DrivenTurn& turn) {
    return fmt::format("{:.0f} mm/s, {:.1f} ms", turn.speed, turn.time / 1e3);
  };
  std::vector<std::string> lines = {fmt::format("{}: {}", name_of(panel.shape.turn), driven(panel.turns.front()))};
  if (panel.turns.size() > 1) lines.push_back("or " + driven(panel.turns.back()));
  if (robot.fixed) return lines;
  lines.push_back(fmt::format("leads {:.1f} and {:.1f} mm", panel.shape.lead_in, panel.shape.lead_out));
  lines.push_back(fmt::format("curve {:.1f} mm, clearance {:.1f} mm", panel.shape.length, panel.shape.clearance));
  return lines;
}

std::string panel_svg(const Panel& panel, const Robot& robot) {
  std::string svg = drawing_of(panel, robot);
  int y = panel.corner.y + 2 * cell + 28;
  for (const std::string& words : figures(panel, robot)) {
    svg +=
        text_svg(panel.corner.x + cell, y, "middle", words.starts_with(name_of(panel.shape.turn)) ? ink : muted, words);
    y += line_height;
  }
  return svg;
}

Legend legend_of(const Robot& robot, std::size_t panels) {
  const int rows = (static_cast<int>(panels) + columns - 1) / columns;
  Legend legend({margin, top + rows * panel_height(robot) + 14}, right);
  legend.add(28, wall(ink, "M3 0h22"), "may stand");
  legend.add(28, open_wall("M0 0h28"), "must be open");
  legend.add(28, path_svg(route, 3, "M0 0h28"),
             robot.fixed ? "a curve from node to node; the real one is not known" : "curve");
  if (!robot.fixed) legend.add(28, path_svg(onwards, 3, "M0 0h28"), "lead: straight");
  if (robot.clearance > 0.0)
    legend.add(28, path_svg(heat_tones[0], 18, "M0 0h28"),
               fmt::format("{:g} mm on both sides, which stay free", robot.clearance));
  return legend;
}

}  // namespace

std::string draw_robot(const Robot& robot, const DriveModel& model) {
  const std::string title = fmt::format("{}: cells of {:g} mm", robot.name, robot.cell);
  std::string svg = heading_svg({margin, 36}, right, title);
  const std::vector<Panel> panels = panels_of(robot, model);
  for (const Panel& panel : panels) svg += panel_svg(panel, robot);
  const Legend legend = legend_of(robot, panels.size());
  const Sheet sheet = {right + margin,
                       legend.bottom() + margin / 2,
                       title,
                       "Each turn among its walls, with its speed, its time and the room that it needs.",
                       {onwards}};
  return sheet.with(svg + legend.svg());
}

}  // namespace labmouse
