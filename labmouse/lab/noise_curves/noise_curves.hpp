// Share of finished contests as a function of noise, and the reasons why the others ended.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "labmouse/contest/physical_record.hpp"
#include "labmouse/lab/numbers/interval.hpp"
#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// Results of one mouse at one noise level.
struct NoisePoint {
  double noise = 0.0;
  int contests = 0;
  int finished = 0;                              ///< with a score
  Interval interval;                             ///< 95 % interval of the share finished, over mazes
  std::optional<double> par1;                    ///< mean score; one without a score counts World::limit_score()
  std::array<int, all_run_ends.size()> ended{};  ///< unfinished contests by what ended them (RunEnd)
};

struct NoiseCurve {
  std::string mouse;
  std::vector<NoisePoint> points;  ///< by increasing noise
};

/// A curve for each mouse, sorted by the share finished, highest first. The races must differ only in their noise, in
/// the physical world or the failure model. Empty if fewer than two races have a noise, or two have the same.
std::vector<NoiseCurve> noise_curves(std::span<const Race> races);

/// Text tables of the shares, the mean scores in the unit of `world`, one of theirs, and what ended the others.
std::string table_of(std::span<const NoiseCurve> curves, const World& world);
/// One self-contained SVG picture. `title` should name mice and mazes.
std::string draw_curves(std::span<const NoiseCurve> curves, const std::string& title);

}  // namespace labmouse
