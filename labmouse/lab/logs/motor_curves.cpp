#include "labmouse/lab/logs/motor_curves.hpp"

#include <algorithm>
#include <cmath>

#include "labmouse/hardware/sense.hpp"

namespace labmouse {
namespace {

// Ticks. Rates are compared in the mean of so many, those of the filter among them.
constexpr std::size_t longest_stretch = 300, shortest_stretch = 80, compared = 56;

/// The means of so many values in a row: shaking and what encoders err by on a turn are quicker, and would come back
/// through the control of a mouse as duties. It keeps sums of curves what they are.
template <class At>
std::vector<double> means_of(std::size_t count, std::size_t filtered, At at) {
  std::vector<double> means;
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    sum += at(i);
    if (i + 1 >= filtered) {
      means.push_back(sum / static_cast<double>(filtered));
      sum -= at(i + 1 - filtered);
    }
  }
  return means;
}

/// Takes the polynomial of that degree out of values at equal distances, as least squares have it.
template <class At>
void take_out_polynomial(std::size_t count, int degree, At at) {
  // Polynomials at right angles to each other over these points, by their recurrence (Gram).
  std::vector<double> before(count, 0.0), now(count, 1.0);
  double square_before = 1.0;
  for (int order = 0; order <= degree; ++order) {
    double square = 0.0, value = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      square += now[i] * now[i];
      value += now[i] * at(i);
    }
    if (!(square > 0.0)) return;
    const double ratio = order == 0 ? 0.0 : square / square_before;
    for (std::size_t i = 0; i < count; ++i) {
      at(i) -= value / square * now[i];
      const double x = (2.0 * static_cast<double>(i) - static_cast<double>(count) + 1.0) / static_cast<double>(count);
      const double next = x * now[i] - ratio * before[i];
      before[i] = now[i];
      now[i] = next;
    }
    square_before = square;
  }
}

/// The squares of the changes of a place over some ticks, as rates.
template <class At>
RateSquares rate_squares(std::size_t count, std::size_t over, At at) {
  RateSquares squares;
  for (std::size_t i = over; i < count; ++i) {
    const double rate = (at(i) - at(i - over)) / (static_cast<double>(over) * tick_seconds);
    squares.sum += rate * rate;
    ++squares.count;
  }
  return squares;
}

}  // namespace

std::vector<TickSpan> one_way_stretches(const AxisLog& log, double slow) {
  std::vector<TickSpan> stretches;
  const auto way_at = [&](std::size_t tick) { return log.rate[tick] > slow ? 1 : log.rate[tick] < -slow ? -1 : 0; };
  for (std::size_t tick = 0; tick < log.rate.size();) {
    const int way = way_at(tick);
    std::size_t end = tick + 1;
    while (end < log.rate.size() && way_at(end) == way) ++end;
    if (const std::size_t size = end - tick; way != 0 && size >= shortest_stretch) {
      const std::size_t parts = (size + longest_stretch - 1) / longest_stretch;
      for (std::size_t part = 0; part < parts; ++part)
        stretches.push_back({tick + part * size / parts, tick + (part + 1) * size / parts});
    }
    tick = end;
  }
  return stretches;
}

StretchCurves::StretchCurves(const AxisLog& log, const TickSpan& span) : filtered_(log.filtered) {
  const double sign = log.rate[span.begin + span.size() / 2] > 0.0 ? 1.0 : -1.0;
  CurveRow once{}, twice{};  // summed up over the ticks before
  std::vector<CurveRow> rows;
  std::vector<double> places;
  double way = 0.0;
  for (std::size_t i = span.begin; i < span.end; ++i) {
    const double place = log.place[i] - log.place[span.begin];
    CurveRow row = twice;
    row[by_rate] = -way;
    row[by_lag] = -once[by_duty];
    rows.push_back(row);
    places.push_back(place);
    // As a body adds up: the duty of this tick changes the rate of the next one, and that the place.
    const double taken = log.taken.empty() ? 0.0 : log.taken[i];
    const double drag = log.rate[i] * std::abs(log.rate[i]);
    const CurveRow pushes = {log.duty[i] - log.factor * taken, log.other[i], -sign, -taken, 0.0, 0.0, -drag};
    for (std::size_t k = 0; k < motor_unknowns; ++k) {
      once[k] += pushes[k] * tick_seconds;
      twice[k] += once[k] * tick_seconds;
    }
    way += place * tick_seconds;
  }
  const auto keep = [](const std::vector<double>& means, auto at) {
    for (std::size_t i = 0; i < means.size(); ++i) at(i) = means[i];
    take_out_polynomial(means.size(), 1, at);
  };
  places_.resize(span.size() + 1 - log.filtered);
  rows_.resize(places_.size());
  keep(means_of(places.size(), log.filtered, [&](std::size_t i) { return places[i]; }),
       [&](std::size_t i) -> double& { return places_[i]; });
  for (std::size_t k = 0; k < motor_unknowns; ++k)
    keep(means_of(rows.size(), log.filtered, [&](std::size_t i) { return rows[i][k]; }),
         [&](std::size_t i) -> double& { return rows_[i][k]; });
}

void StretchCurves::add_to(LeastSquares& problem) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) problem.add(rows_[i], places_[i]);
}

RateSquares StretchCurves::left_by(std::span<const double> answer) const {
  return rate_squares(rows_.size(), compared - filtered_, [&](std::size_t i) {
    double left = places_[i];
    for (std::size_t k = 0; k < motor_unknowns; ++k) left -= answer[k] * rows_[i][k];
    return left;
  });
}

double noise_of(const AxisLog& log, std::span<const TickSpan> stretches) {
  constexpr std::size_t piece = 120;
  constexpr int smooth = 3;
  std::vector<double> squares;
  for (const TickSpan& stretch : stretches)
    for (std::size_t begin = stretch.begin; begin + piece <= stretch.end; begin += piece) {
      std::vector<double> places =
          means_of(piece, log.filtered, [&](std::size_t i) { return log.place[begin + i] - log.place[begin]; });
      take_out_polynomial(places.size(), smooth, [&](std::size_t i) -> double& { return places[i]; });
      const RateSquares left =
          rate_squares(places.size(), compared - log.filtered, [&](std::size_t i) { return places[i]; });
      squares.push_back(left.sum / static_cast<double>(left.count));
    }
  if (squares.empty()) return 0.0;
  std::nth_element(squares.begin(), squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2), squares.end());
  return std::sqrt(squares[squares.size() / 2]);
}

}  // namespace labmouse
