#include "labmouse/lab/logs/count_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "labmouse/lab/numbers/least_squares.hpp"

namespace labmouse {
namespace {

constexpr std::size_t least_places = 6, most_count_blocks = 20;

struct KnownPlace {
  double counts;  ///< mean of both wheels
  double way;     ///< mm
};

double counts_at(const Log& log, std::size_t row) {
  return (log.of(LogRole::left_count)[row] + log.of(LogRole::right_count)[row]) / 2.0;
}

std::vector<KnownPlace> places_of(const Log& log) {
  std::vector<KnownPlace> places;
  const auto way = log.of(LogRole::way);
  for (std::size_t row = 0; row < way.size(); ++row)
    if (!std::isnan(way[row])) places.push_back({counts_at(log, row), way[row]});
  return places;
}

struct SlopeFit {
  double slope = 0.0, error = 0.0;
  double missed = 0.0;  ///< squares of blocks left out
};

constexpr std::array<std::optional<double>, 2> both_free = {};

/// Of points in blocks: rows of two unknowns, the slope and what is common.
std::optional<SlopeFit> slope_of(const std::vector<std::vector<std::array<double, 3>>>& blocks) {
  LeastSquares all(2);
  std::vector<LeastSquares> parts;
  for (const auto& block : blocks) {
    LeastSquares& part = parts.emplace_back(2);
    for (const auto& [counts, one, way] : block) part.add(std::array{counts, one}, way);
    all += part;
  }
  // Differences have nothing in common.
  const auto fixed =
      blocks.front().front()[1] == 0.0 ? std::array<std::optional<double>, 2>{std::nullopt, 0.0} : both_free;
  const auto answer = all.solution(fixed);
  if (!answer) return std::nullopt;
  SlopeFit fit{answer->front()};
  std::vector<double> without;
  for (const LeastSquares& part : parts) {
    LeastSquares rest = all;
    rest -= part;
    const auto other = rest.solution(fixed);
    if (!other) return std::nullopt;
    without.push_back(other->front());
    fit.missed += part.squares(*other);
  }
  fit.error = jackknife_error(without);
  return fit;
}

void fit_places(const std::vector<KnownPlace>& places, CountFit& fit) {
  if (places.size() < least_places) {
    fit.refusal = fmt::format("the way is known in {} rows, and must be in {}", places.size(), least_places);
    return;
  }
  const std::size_t count = std::min(most_count_blocks, places.size() - 1);
  std::vector<std::vector<std::array<double, 3>>> points(count), steps(count);
  // Around their middle, so that what is common to all is small.
  KnownPlace middle{0.0, 0.0};
  for (const KnownPlace& place : places) {
    middle.counts += place.counts / static_cast<double>(places.size());
    middle.way += place.way / static_cast<double>(places.size());
  }
  for (std::size_t i = 0; i < places.size(); ++i)
    points[i * count / places.size()].push_back({places[i].counts - middle.counts, 1.0, places[i].way - middle.way});
  for (std::size_t block = 0; block < count; ++block) {
    const KnownPlace& from = places[block * (places.size() - 1) / count];
    const KnownPlace& to = places[(block + 1) * (places.size() - 1) / count];
    steps[block].push_back({to.counts - from.counts, 0.0, to.way - from.way});
  }
  const auto line = slope_of(points), sums = slope_of(steps);
  const auto [first, last] = std::minmax_element(
      places.begin(), places.end(), [](const KnownPlace& a, const KnownPlace& b) { return a.way < b.way; });
  fit.way = last->way - first->way;
  if (!line || !sums || !(line->slope > 0.0)) {
    fit.refusal = "the way that is known does not grow with the counts: are these the right columns?";
    return;
  }
  fit.missed = std::sqrt(line->missed / static_cast<double>(places.size()));
  fit.count = said_within(line->slope, std::max(line->error, sums->error), 0.1 * line->slope);
  if (!fit.count.said()) fit.refusal = "counts and the way that is known do not go together";
}

}  // namespace

CountFit fit_count(const Log& log, const WholeWay& whole) {
  CountFit fit;
  if (!log.has(LogRole::left_count)) {
    fit.refusal = "the log has no counts";
  } else if (whole.way > 0.0) {
    const double counts = std::abs(counts_at(log, log.times.size() - 1) - counts_at(log, 0));
    fit.way = whole.way;
    // A count more or less at each end is no more than a ruler sees.
    if (counts >= 10.0)
      fit.count = {whole.way / counts, whole.way / counts * std::max(whole.error / whole.way, 1.0 / counts)};
    if (!fit.count.said()) fit.refusal = "the encoders hardly count on that way";
  } else if (!log.has(LogRole::way)) {
    fit.refusal = "the log has no known way";
  } else {
    fit_places(places_of(log), fit);
  }
  return fit;
}

}  // namespace labmouse
