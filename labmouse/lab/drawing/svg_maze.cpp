// The layers of an SVG picture that show the maze.
#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/drawing/palette.hpp"
#include "labmouse/lab/drawing/scene.hpp"
#include "labmouse/lab/drawing/walls.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse::drawing {
namespace {

std::string posts(const Frame& frame) {
  std::string path;
  for (int y = frame.origin.y; y <= frame.bottom(); y += Frame::cell)
    for (int x = frame.origin.x; x <= frame.right(); x += Frame::cell) path += fmt::format("M{} {}h0", x, y);
  return path;
}

/// The attributes of letters and labels, with an outline in the background colour if lines run below them.
std::string writing(const Scene& scene) {
  if (!scene.layers.search_run) return fill(ink);
  return fill_and_stroke(ink, paper) + " stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\"";
}

/// The label, cut and ended by an ellipsis if it would not fit into the cell.
std::string shortened(const std::string& label) {
  constexpr std::size_t most = 6;
  const std::u32string all = printable(label);
  return xml_escaped(all.size() > most ? utf8(all.substr(0, most - 1)) + "…" : utf8(all));
}

std::string letters(const Scene& scene) {
  const bool corner = scene.crowded() || scene.layers.mouse;
  const int shift = scene.rims() > 0 ? Frame::rim / 2 : 0;
  const auto letter = [&](Cell cell, char name) {
    const Point at =
        corner ? scene.frame.corner(cell).moved(9 + shift, 13 + shift) : scene.frame.centre(cell).moved(0, 6);
    return fmt::format("<text x=\"{}\" y=\"{}\">{}</text>", at.x, at.y, name);
  };
  std::string all = fmt::format("<g {} font-weight=\"600\" text-anchor=\"middle\" font-size=\"{}\">", writing(scene),
                                corner ? 10 : 17);
  all += letter(scene.maze.start(), 'S');
  scene.maze.goals().for_each([&](Cell cell) {
    if (cell != scene.maze.start()) all += letter(cell, 'G');
  });
  return all + "</g>\n";
}

/// The numbers 0 to count - 1, in steps of `every`.
template <class Place>
std::string numbers(int count, int every, Place place) {
  std::string all;
  for (int number = 0; number < count; number += every) {
    const Point at = place(number);
    all += fmt::format("<text x=\"{}\" y=\"{}\">{}</text>", at.x, at.y, number);
  }
  return all;
}

}  // namespace

std::string segment(const Frame& frame, Wall wall) {
  const Point corner = frame.corner(wall.cell);
  if (wall.side == Heading::north) return fmt::format("M{} {}h{}", corner.x, corner.y, Frame::cell);
  return fmt::format("M{} {}v{}", corner.x + Frame::cell, corner.y, Frame::cell);
}

std::string unknown_svg(const std::string& path) {
  if (path.empty()) return "";
  return fmt::format("<path {} stroke-width=\"2\" stroke-dasharray=\"4 4\" d=\"{}\"/>\n", stroke(faint), path);
}

std::string wall_svg(const Tone& tone, const std::string& path) {
  if (path.empty()) return "";
  return fmt::format("<path {} stroke-width=\"{}\" stroke-linecap=\"round\" d=\"{}\"/>\n", stroke(tone), Frame::wall,
                     path);
}

std::string walls_svg(const Scene& scene) {
  std::string closed;
  std::string unknown;
  std::string guessed_open;
  std::string guessed_closed;
  for_each_wall(scene.frame.size, [&](Wall wall) {
    const WallLook look = look_of(scene.maze, scene.layers, wall);
    if (look == WallLook::closed) closed += segment(scene.frame, wall);
    if (look == WallLook::unknown) unknown += segment(scene.frame, wall);
    if (look == WallLook::guessed_open) guessed_open += segment(scene.frame, wall);
    if (look == WallLook::guessed_closed) guessed_closed += segment(scene.frame, wall);
  });
  return unknown_svg(unknown) + wall_svg(post, posts(scene.frame)) + wall_svg(wrong, guessed_open) +
         wall_svg(to_goal, guessed_closed) + wall_svg(ink, closed);
}

std::string labels_svg(const Scene& scene) {
  if (!scene.layers.label) return letters(scene);
  // With lines through the middles, labels stand in a corner that the lines leave free.
  const bool corner = scene.lined();
  std::string all = fmt::format("<g {} text-anchor=\"{}\" font-size=\"{}\">", writing(scene), corner ? "end" : "middle",
                                corner ? 10 : 12);
  CellSet::all(scene.frame.size).for_each([&](Cell cell) {
    const std::string label = shortened(scene.layers.label(cell));
    const Point middle = scene.frame.centre(cell);
    const Point at = corner ? middle.moved(Frame::cell / 2 - 5, Frame::cell / 2 - 6) : middle.moved(0, 5);
    if (!label.empty()) all += fmt::format("<text x=\"{}\" y=\"{}\">{}</text>", at.x, at.y, label);
  });
  return all + "</g>\n" + letters(scene);
}

std::string coordinates_svg(const Scene& scene) {
  if (!scene.layers.coordinates) return "";
  const Frame& frame = scene.frame;
  const int longest = std::max(frame.size.width, frame.size.height);
  const int every = longest <= 16 ? 1 : longest <= 32 ? 2 : 4;
  const auto under = [&](int x) { return Point{frame.centre({x, 0}).x, frame.bottom() + 18}; };
  const auto beside = [&](int y) { return Point{frame.origin.x - 8, frame.centre({0, y}).y + 4}; };
  return fmt::format("<g {} font-size=\"11\"><g text-anchor=\"middle\">{}</g><g text-anchor=\"end\">{}</g></g>\n",
                     fill(muted), numbers(frame.size.width, every, under), numbers(frame.size.height, every, beside));
}

}  // namespace labmouse::drawing
