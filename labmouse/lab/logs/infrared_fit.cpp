#include "labmouse/lab/logs/infrared_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "labmouse/functions/angles.hpp"
#include "labmouse/hardware/beam.hpp"
#include "labmouse/lab/logs/log_motion.hpp"
#include "labmouse/lab/numbers/least_squares.hpp"
#include "labmouse/lab/numbers/statistics.hpp"

namespace labmouse {
namespace {

constexpr std::size_t least_runs = 5, most_infrared_blocks = 20;

/// Readings of a sensor at almost one distance.
struct Reading {
  std::size_t beam = 0;
  double farther = 0.0;  ///< mm that the beam goes beyond what it does in the middle of a cell
  double level = 0.0;    ///< counts, mean
  double rows = 0.0;
};
/// Of one wall, as the mouse passes it or comes to it.
using Run = std::vector<Reading>;

/// A wall that a log has distances of, and the sensors that see it.
struct SeenWall {
  LogRole distance;
  std::vector<std::pair<std::size_t, LogRole>> sensors;
};
const std::vector<SeenWall>& seen_walls() {
  static const std::vector<SeenWall> walls = {
      {LogRole::wall_right, {{static_cast<std::size_t>(BeamPlace::right), LogRole::ir_right}}},
      {LogRole::wall_left, {{static_cast<std::size_t>(BeamPlace::left), LogRole::ir_left}}},
      {LogRole::wall_ahead,
       {{static_cast<std::size_t>(BeamPlace::right_ahead), LogRole::ir_right_ahead},
        {static_cast<std::size_t>(BeamPlace::left_ahead), LogRole::ir_left_ahead}}}};
  return walls;
}

/// Where the distance is known, and in what parts: a run ends where it jumps, or changes after it was the same in some
/// rows, as of a mouse that is put from place to place; a reading ends where it has changed.
struct WallPart {
  TickSpan rows;
  bool begins_run = false;
};
std::vector<WallPart> wall_parts_of(std::span<const double> walls) {
  constexpr double jump = 3.0, same = 1.0;  // mm
  constexpr std::size_t long_same = 10;
  std::vector<WallPart> parts;
  std::size_t unchanged = 0;  // rows
  double before = std::numeric_limits<double>::quiet_NaN(), begun = 0.0;
  for (std::size_t row = 0; row < walls.size(); ++row) {
    const double wall = walls[row];
    // False where one of them is not known.
    const bool goes_on = wall == before || (std::abs(wall - before) <= jump && unchanged < long_same);
    unchanged = wall == before ? unchanged + 1 : 0;
    before = wall;
    if (std::isnan(wall)) continue;
    if (!goes_on || std::abs(wall - begun) > same) {
      parts.push_back({{row, row}, !goes_on});
      begun = wall;
    }
    parts.back().rows.end = row + 1;
  }
  return parts;
}

double mean_in_rows(std::span<const double> values, const TickSpan& rows) {
  return mean(values.subspan(rows.begin, rows.size()));
}

/// The runs of a wall, in the order of the log.
std::vector<Run> runs_of(const Log& log, const SeenWall& wall, const Hardware& hardware, double cell) {
  std::vector<Run> runs;
  const double face = cell / 2.0 - half_wall_of(cell);
  for (const WallPart& part : wall_parts_of(log.of(wall.distance))) {
    if (part.begins_run) runs.emplace_back();
    const double distance = mean_in_rows(log.of(wall.distance), part.rows);
    for (const auto& [beam, role] : wall.sensors) {
      if (!log.has(role)) continue;
      const Beam& at = hardware.sensors.infrared.beams[beam];
      const Direction way = direction_of(at.angle);
      const double slant = looks_aside(at) ? std::abs(way.sine) : way.cosine;
      runs.back().push_back({beam, (distance - face) / slant, mean_in_rows(log.of(role), part.rows),
                             static_cast<double>(part.rows.size())});
    }
  }
  return runs;
}

// The unknowns: ln of each sensor's gain, 1/fall, and those of other laws: a bend, and an offset in counts.
enum InfraredUnknown : std::size_t { by_distance = beam_count, by_bend, by_offset };
constexpr std::size_t infrared_unknowns = beam_count + 3;
using Law = std::vector<double>;
using FixedLaw = std::array<std::optional<double>, infrared_unknowns>;
using LawRow = std::array<double, infrared_unknowns>;

/// All runs, wall by wall, and which sensors have enough of them.
struct Readings {
  std::vector<std::vector<Run>> walls;
  std::array<std::size_t, beam_count> runs{};  ///< of each sensor

  bool fits(std::size_t beam) const { return runs[beam] >= least_runs; }
  bool any() const { return *std::max_element(runs.begin(), runs.end()) >= least_runs; }
};

double expected_by(const Law& law, const Reading& reading) {
  return std::exp(law[reading.beam] - law[by_distance] * reading.farther);
}

/// Those readings that are neither lost in noise nor cut: by what a law expects of them where there is one, so that
/// errors do not choose.
Readings readable(const Readings& all, const Hardware& hardware, const Law* law) {
  const double lowest = std::max(8.0, 5.0 * hardware.noise.infrared);
  const double highest = 0.9 * hardware.sensors.infrared.most;
  Readings kept;
  for (const std::vector<Run>& wall : all.walls) {
    std::vector<Run>& runs = kept.walls.emplace_back();
    for (const Run& run : wall) {
      Run rest;
      for (const Reading& reading : run) {
        const double level = law == nullptr ? reading.level : expected_by(*law, reading);
        if (level >= lowest && level <= highest && reading.level > 0.0 && all.fits(reading.beam))
          rest.push_back(reading);
      }
      if (rest.empty()) continue;
      for (std::size_t beam = 0; beam < beam_count; ++beam)
        if (std::any_of(rest.begin(), rest.end(), [&](const Reading& reading) { return reading.beam == beam; }))
          ++kept.runs[beam];
      runs.push_back(std::move(rest));
    }
  }
  return kept;
}

struct LawFit {
  Law law;
  std::array<double, beam_count> weights{};  ///< of the sensors' gains in their mean
  double gain = 0.0, fall = 0.0, gain_error = 0.0, fall_error = 0.0;
  std::vector<double> missed;  ///< by block, squares of ln
};

/// The problem that readings pose, in blocks: each has a part of the runs of each wall. How much a reading weighs, and
/// what an offset would do to it, is by what a law expects where there is one, so that errors say nothing of
/// themselves.
class InfraredProblem {
 public:
  InfraredProblem(const Readings& readings, const Noise& noise, const Law* law)
      : readings_(readings), spread_(std::max(0.01, noise.infrared_gain)) {
    constexpr double usual = 0.05;  // share by which places differ
    std::size_t count = most_infrared_blocks;
    for (std::size_t beam = 0; beam < beam_count; ++beam)
      if (readings.fits(beam)) count = std::min(count, readings.runs[beam]);
    blocks_.assign(count, LeastSquares(infrared_unknowns));
    for (const std::vector<Run>& runs : readings.walls)
      for (std::size_t i = 0; i < runs.size(); ++i)
        for (const Reading& reading : runs[i]) {
          if (!readings.fits(reading.beam)) continue;
          const double level = law == nullptr ? reading.level : expected_by(*law, reading);
          LawRow row{};
          row[reading.beam] = 1.0;
          row[by_distance] = -reading.farther;
          row[by_bend] = reading.farther * reading.farther;
          row[by_offset] = 1.0 / level;
          // All readings of a run weigh as much as one that is sure: they have the same wall.
          const double unsure = noise.infrared / level, share = 1.0 / static_cast<double>(runs[i].size());
          const double weight = share * usual * usual / (usual * usual + unsure * unsure / reading.rows);
          blocks_[i * count / runs.size()].add(row, std::log(reading.level), weight);
          weight_ += weight;
        }
    for (const LeastSquares& block : blocks_) all_ += block;
  }

  /// Nothing where it is not determined, or readings grow with the distance.
  std::optional<LawFit> fit(const FixedLaw& fixed) const {
    const auto law = law_of(all_, fixed);
    if (!law) return std::nullopt;
    std::vector<Law> others;
    LawFit fit;
    for (const LeastSquares& block : blocks_) {
      LeastSquares rest = all_;
      rest -= block;
      const auto other = law_of(rest, fixed);
      if (!other) return std::nullopt;
      fit.missed.push_back(block.squares(*other));
      others.push_back(*other);
    }
    fit.law = *law;
    const auto error_of = [&](auto number) {
      std::vector<double> numbers;
      for (const Law& other : others) numbers.push_back(number(other));
      return jackknife_error(numbers);
    };
    // One that is sure counts for more; but sensors differ, however sure each of them is.
    double together = 0.0;
    for (std::size_t beam = 0; beam < beam_count; ++beam) {
      if (!readings_.fits(beam)) continue;
      const double error = error_of([&](const Law& one) { return one[beam]; });
      together += fit.weights[beam] = 1.0 / (error * error + spread_ * spread_);
    }
    for (double& weight : fit.weights) weight /= together;
    const auto gain_of = [&](const Law& one) {
      double gain = 0.0;
      for (std::size_t beam = 0; beam < beam_count; ++beam)
        if (fit.weights[beam] > 0.0) gain += fit.weights[beam] * std::exp(one[beam]);
      return gain;
    };
    const auto fall_of = [](const Law& one) { return 1.0 / one[by_distance]; };
    fit.gain = gain_of(*law);
    fit.fall = fall_of(*law);
    double squares = 0.0;
    for (const double weight : fit.weights) squares += weight * weight;
    fit.gain_error = std::hypot(error_of(gain_of), fit.gain * spread_ * std::sqrt(squares));
    fit.fall_error = error_of(fall_of);
    return fit;
  }

  /// The plain law, with the gains of the sensors that have enough runs.
  FixedLaw plain() const {
    FixedLaw fixed{};
    for (std::size_t beam = 0; beam < beam_count; ++beam)
      if (!readings_.fits(beam)) fixed[beam] = 0.0;
    fixed[by_bend] = fixed[by_offset] = 0.0;
    return fixed;
  }
  double rms(const std::vector<double>& squares) const {
    double sum = 0.0;
    for (const double square : squares) sum += square;
    return std::sqrt(sum / weight_);
  }

 private:
  static std::optional<Law> law_of(const LeastSquares& sums, const FixedLaw& fixed) {
    auto law = sums.solution(fixed);
    return law && (*law)[by_distance] > 0.0 ? law : std::nullopt;
  }

  const Readings& readings_;
  double spread_;  ///< by which the gains of sensors differ, as a share
  std::vector<LeastSquares> blocks_;
  LeastSquares all_{infrared_unknowns};
  double weight_ = 0.0;
};

/// Adds to the errors what other laws would change, if they fit better, and what no law explains.
void widen_by_laws(const InfraredProblem& problem, double usual, LawFit& fit, InfraredFit& result) {
  double left = problem.rms(fit.missed);
  for (const InfraredUnknown more : {by_bend, by_offset}) {
    FixedLaw fixed = problem.plain();
    fixed[more] = std::nullopt;
    const auto other = problem.fit(fixed);
    if (!other || !leaves_less(other->missed, fit.missed)) continue;
    result.bends = true;
    left = std::min(left, problem.rms(other->missed));
    fit.gain_error = std::hypot(fit.gain_error, other->gain - fit.gain);
    fit.fall_error = std::hypot(fit.fall_error, other->fall - fit.fall);
  }
  constexpr double much = 3.0;
  if (left <= much * usual) return;
  result.bends = true;
  fit.gain_error = std::hypot(fit.gain_error, left * fit.gain);
  fit.fall_error = std::hypot(fit.fall_error, left * fit.fall);
}

}  // namespace

InfraredFit fit_infrared(const Log& log, const Hardware& hardware, double cell) {
  InfraredFit result;
  Readings all;
  all.runs.fill(least_runs);  // until they are looked through
  for (const SeenWall& wall : seen_walls())
    if (log.has(wall.distance)) all.walls.push_back(runs_of(log, wall, hardware, cell));
  Readings kept = readable(all, hardware, nullptr);
  std::optional<LawFit> fit;
  constexpr int rounds = 5;
  for (int round = 0; round < rounds && kept.any(); ++round) {
    const InfraredProblem problem(kept, hardware.noise, fit ? &fit->law : nullptr);
    fit = problem.fit(problem.plain());
    if (!fit) break;
    all.runs = kept.runs;
    kept = readable(all, hardware, &fit->law);
  }
  if (!kept.any()) {
    result.refusal = all.walls.empty()
                         ? "the log has no readings of a wall at a known distance"
                         : fmt::format("no sensor has readings between noise and limit at {} places", least_runs);
    return result;
  }
  const Law expected = fit ? fit->law : Law();
  const InfraredProblem problem(kept, hardware.noise, fit ? &expected : nullptr);
  if (fit) fit = problem.fit(problem.plain());
  if (!fit) {
    result.refusal = "readings do not fall with the distance, or the distances hardly differ";
    return result;
  }
  result.missed = problem.rms(fit->missed);
  widen_by_laws(problem, hardware.noise.reflectance, *fit, result);
  for (std::size_t beam = 0; beam < beam_count; ++beam) {
    if (!kept.fits(beam)) continue;
    result.of_beam[beam] = std::exp(fit->law[beam]);
    result.places += kept.runs[beam];
  }
  constexpr double sure_share = 0.25;
  result.gain = said_within(fit->gain, fit->gain_error, sure_share * fit->gain);
  result.fall = said_within(fit->fall, fit->fall_error, sure_share * fit->fall);
  if (!result.gain.said() || !result.fall.said()) {
    result.refusal = fmt::format("its gain comes out as {:.4g} +- {:.2g}, its fall-off as {:.3g} +- {:.2g} mm: {}",
                                 fit->gain, fit->gain_error, fit->fall, fit->fall_error,
                                 result.bends ? "readings follow another law" : "distances differ too little");
    result.gain.error = result.fall.error = 0.0;
  }
  return result;
}

}  // namespace labmouse
