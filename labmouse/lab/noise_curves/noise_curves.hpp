// How mice fare as noise grows: the share of contests that they finish, and what ended the others.
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

/// The contests of a mouse under one noise.
struct NoisePoint {
  double noise = 0.0;
  int contests = 0;
  int finished = 0;                              ///< with a score
  Interval interval;                             ///< of the share of those, over mazes
  std::optional<double> par1;                    ///< mean seconds, the others counted as the time limit
  std::array<int, all_run_ends.size()> ended{};  ///< the others, by RunEnd
};

struct NoiseCurve {
  std::string mouse;
  std::vector<NoisePoint> points;  ///< by increasing noise
};

/// Of races that differ by their noise alone, in the physical or the failure model: a curve for each mouse, those that
/// finish most first. Empty where there are fewer than two such races.
std::vector<NoiseCurve> noise_curves(std::span<const Race> races);

/// Shares, times, and what ended the others, in lines.
std::string table_of(std::span<const NoiseCurve> curves);
/// One self-contained SVG picture; `title` says of which mice in which mazes.
std::string draw_curves(std::span<const NoiseCurve> curves, const std::string& title);

}  // namespace labmouse
