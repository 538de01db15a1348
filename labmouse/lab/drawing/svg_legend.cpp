// The legend of an SVG picture: a sample with words for each layer present.
#include <fmt/format.h>

#include "labmouse/lab/drawing/scene.hpp"
#include "labmouse/lab/drawing/words.hpp"

namespace labmouse::drawing {
namespace {

std::string swatch(const Tone& tone, char letter) {
  return fmt::format(
      "<rect y=\"-9\" width=\"18\" height=\"18\" rx=\"2\" {}/><text x=\"9\" y=\"4\" font-size=\"11\" "
      "font-weight=\"600\" text-anchor=\"middle\" {}>{}</text>",
      fill(tone), fill(ink), letter);
}

std::string route_sample() {
  return fmt::format(
      "<path {} stroke-width=\"4\" stroke-linecap=\"round\" stroke-opacity=\"0.8\" d=\"M2 0h24\"/>"
      "<circle cx=\"26\" cy=\"0\" r=\"6\" {}/>",
      stroke(route), fill(route));
}

void add_heat(Legend& legend, const Heat& heat) {
  constexpr int step = 12;
  const int shown = heat.peak() == 1 ? 1 : Heat::levels;
  std::string ramp;
  for (int level = 0; level < shown; ++level)
    ramp += fmt::format("<rect x=\"{}\" y=\"-7\" width=\"{}\" height=\"14\" {}/>", level * step, step,
                        fill(heat_tones[static_cast<std::size_t>(level)]));
  legend.add(shown * step, ramp,
             heat.peak() == 1 ? "1 visit to a cell" : fmt::format("1 to {} visits to a cell", heat.peak()));
}

/// Both tones of the discovered cells, which include the visited ones.
std::string discovered_swatch() {
  return fmt::format(
      "<rect y=\"-9\" width=\"18\" height=\"18\" rx=\"2\" {}/><rect x=\"18\" y=\"-9\" width=\"18\" "
      "height=\"18\" rx=\"2\" {}/>",
      fill(visited), fill(discovered));
}

void add_search_run(Legend& legend, const SearchLegs& search_run) {
  legend.add(28, leg_svg(to_goal, "M0 0h28"), to_goal_words(search_run));
  if (search_run.onwards.size() > 1) legend.add(28, leg_svg(onwards, "M0 0h28"), onwards_words(search_run));
}

void add_explored(Legend& legend, const ExploredCells& explored) {
  legend.add(18, fmt::format("<rect y=\"-9\" width=\"18\" height=\"18\" rx=\"2\" {}/>", fill(visited)),
             visited_words(explored));
  legend.add(36, discovered_swatch(), discovered_words(explored));
}

void add_candidates(Legend& legend, const StepReasons& choice) {
  legend.add(28, candidate_svg("M0 0h28", false, true), candidates_words(choice));
  legend.add(28, candidate_svg("M0 0h28", true, true), chosen_words(choice.reasons));
}

}  // namespace

Legend legend_of(const Scene& scene, Point begin, int right) {
  Legend legend(begin, right);
  legend.add(18, swatch(start, 'S'), "start");
  legend.add(18, swatch(goal, 'G'), "goal");
  if (!scene.legs.empty()) legend.add(32, route_sample(), route_words(scene.legs));
  if (scene.layers.search_run) add_search_run(legend, *scene.layers.search_run);
  if (scene.heat.peak() > 0) add_heat(legend, scene.heat);
  if (scene.layers.explored) add_explored(legend, *scene.layers.explored);
  if (scene.layers.wrong) legend.add(28, wall_svg(wrong, "M0 0h28"), wrong_words(scene.layers));
  if (scene.layers.false_walls) legend.add(28, wall_svg(to_goal, "M0 0h28"), false_words(*scene.layers.false_walls));
  if (scene.layers.unknown) legend.add(28, unknown_svg("M0 0h28"), "unknown wall");
  if (scene.layers.candidates) add_candidates(legend, *scene.layers.candidates);
  if (scene.layers.mouse) legend.add(22, mouse_svg(Point{11, 0}, Heading::north), "mouse");
  if (scene.layers.label && !scene.layers.label_meaning.empty())
    legend.add(22, fmt::format("<text y=\"5\" font-size=\"12\" {}>123</text>", fill(ink)), scene.layers.label_meaning);
  return legend;
}

}  // namespace labmouse::drawing
