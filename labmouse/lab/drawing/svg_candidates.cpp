// The layer of an SVG picture that shows the candidates of a choice.
#include <fmt/format.h>

#include "labmouse/lab/drawing/palette.hpp"
#include "labmouse/lab/drawing/scene.hpp"
#include "labmouse/lab/drawing/words.hpp"

namespace labmouse::drawing {
namespace {

/// Path data of a candidate: its wall, or for a goal a frame in its cell.
std::string path_of(const Frame& frame, const Candidate& candidate) {
  if (!candidate.goal) return segment(frame, candidate.wall);
  const Point corner = frame.corner(candidate.seen_from).moved(Frame::rim, Frame::rim);
  constexpr int side = Frame::cell - 2 * Frame::rim;
  return fmt::format("M{} {}h{}v{}h-{}z", corner.x, corner.y, side, side, side);
}

/// Place of the candidate's number: the middle of the wall, or of the goal's lower edge.
Point middle_of(const Frame& frame, const Candidate& candidate) {
  constexpr int half = Frame::cell / 2;
  if (candidate.goal) return frame.centre(candidate.seen_from).moved(0, half - Frame::rim);
  const Point corner = frame.corner(candidate.wall.cell);
  return candidate.wall.side == Heading::north ? corner.moved(half, 0) : corner.moved(Frame::cell, half);
}

}  // namespace

std::string candidate_svg(const std::string& path, bool chosen, bool worth) {
  return fmt::format("<path {} stroke-width=\"{}\"{}{} d=\"{}\"/>\n", stroke(candidate), chosen ? 7 : 4,
                     chosen ? "" : " stroke-dasharray=\"6 4\"", worth ? "" : " stroke-opacity=\"0.5\"", path);
}

std::string candidates_svg(const Scene& scene) {
  if (!scene.layers.candidates) return "";
  const Reasons& reasons = scene.layers.candidates->reasons;
  std::string lines, numbers;
  for (const Candidate& each : reasons.candidates) {
    const bool chosen = reasons.chosen >= 0 && &each == &reasons.candidates[static_cast<std::size_t>(reasons.chosen)];
    lines += candidate_svg(path_of(scene.frame, each), chosen, each.worth);
    const Point at = middle_of(scene.frame, each);
    numbers += fmt::format("<text x=\"{}\" y=\"{}\"{}>{}</text>", at.x, at.y + 3, chosen ? " font-weight=\"700\"" : "",
                           through_words(each, reasons));
  }
  return lines + fmt::format(
                     "<g {} stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\" "
                     "text-anchor=\"middle\" font-size=\"9\">{}</g>\n",
                     fill_and_stroke(ink, paper), numbers);
}

}  // namespace labmouse::drawing
