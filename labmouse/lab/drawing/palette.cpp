#include "labmouse/lab/drawing/palette.hpp"

#include <fmt/format.h>

namespace labmouse::drawing {
namespace {

std::string dark_rules(const Tone& tone) {
  return fmt::format(".labmouse .fill-{0}{{fill:{1}}}.labmouse .stroke-{0}{{stroke:{1}}}\n", tone.name, tone.dark);
}

}  // namespace

std::string fill(const Tone& tone) { return fmt::format(R"(class="fill-{}" fill="{}")", tone.name, tone.light); }

std::string stroke(const Tone& tone) {
  return fmt::format(R"(class="stroke-{}" fill="none" stroke="{}")", tone.name, tone.light);
}

std::string fill_and_stroke(const Tone& area, const Tone& line) {
  return fmt::format(R"(class="fill-{} stroke-{}" fill="{}" stroke="{}")", area.name, line.name, area.light,
                     line.light);
}

std::string dark_style_sheet(std::span<const Tone> more) {
  std::string rules = "@media (prefers-color-scheme:dark){\n";
  for (const Tone& tone : {paper, ink, muted, faint, post, start, goal, route}) rules += dark_rules(tone);
  for (const Tone& tone : heat_tones) rules += dark_rules(tone);
  for (const Tone& tone : more) rules += dark_rules(tone);
  return rules + "}";
}

}  // namespace labmouse::drawing
