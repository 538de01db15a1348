// Share of finished contests as a function of the noise or of the variation, and the reasons why the others ended.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/contest/physical_record.hpp"
#include "labmouse/lab/numbers/interval.hpp"
#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// Results of one mouse at one scale of the errors.
struct FinishPoint {
  double at = 0.0;  ///< scale of the noise or of the variation
  int contests = 0;
  int finished = 0;                              ///< with a score
  Interval interval;                             ///< 95 % interval of the share finished, over mazes
  std::optional<double> par1;                    ///< mean score; one without a score counts WorldTraits::limit_score
  std::array<int, all_run_ends.size()> ended{};  ///< unfinished contests by what ended them (RunEnd)
};

struct FinishCurve {
  std::string mouse;
  std::vector<FinishPoint> points;  ///< by increasing scale
};

struct FinishCurves {
  std::string_view scale;           ///< what is scaled: "noise" or "variation"
  std::vector<FinishCurve> curves;  ///< one for each mouse, sorted by the share finished, highest first
};

/// The curves of races that differ only in their noise or only in their variation, in the physical world or the failure
/// model; without curves if there are fewer than two, or if two have the same scale.
FinishCurves finish_curves(std::span<const Race> races);

/// Text tables of the shares, the mean scores in the unit of `world`, one of theirs, and what ended the others.
std::string table_of(const FinishCurves& curves, const World& world);
/// One self-contained SVG picture. `title` should name mice and mazes.
std::string draw_curves(const FinishCurves& curves, const std::string& title);

}  // namespace labmouse
