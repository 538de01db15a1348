#include "labmouse/lab/logs/gyro_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "labmouse/lab/numbers/least_squares.hpp"

namespace labmouse {
namespace {

/// Squares of first and second differences, with how many there are.
struct Differences {
  double first = 0.0, second = 0.0, count = 0.0;

  Differences& operator+=(const Differences& other) {
    first += other.first;
    second += other.second;
    count += other.count;
    return *this;
  }
  Differences operator-(const Differences& other) const {
    return {first - other.first, second - other.second, count - other.count};
  }
  double by_first() const { return std::sqrt(first / count / 2.0); }
  double by_second() const { return std::sqrt(second / count / 6.0); }
};

/// By three rows in a row, all at rest.
std::vector<Differences> differences_of(const Log& log, const std::vector<TickSpan>& rests, double& step) {
  const auto gyro = log.of(LogRole::gyro);
  std::vector<Differences> all;
  step = 0.0;
  std::size_t row = 0;
  for (const TickSpan& rest : rests) {
    while (row < log.times.size() && log.times[row] < static_cast<double>(rest.begin)) ++row;
    const std::size_t begin = row;
    while (row < log.times.size() && log.times[row] < static_cast<double>(rest.end)) ++row;
    for (std::size_t i = begin + 2; i < row; ++i) {
      const double last = gyro[i] - gyro[i - 1], before = gyro[i - 1] - gyro[i - 2];
      all.push_back({last * last, (last - before) * (last - before), 1.0});
      if (last != 0.0) step = step == 0.0 ? std::abs(last) : std::min(step, std::abs(last));
    }
  }
  return all;
}

/// All of them in so many parts, one behind the other.
std::vector<Differences> parts_of(const std::vector<Differences>& all, std::size_t count) {
  std::vector<Differences> parts(count);
  for (std::size_t i = 0; i < all.size(); ++i) parts[i * count / all.size()] += all[i];
  return parts;
}

}  // namespace

GyroFit fit_gyro(const Log& log, const LogMotion& motion) {
  GyroFit fit;
  if (!log.has(LogRole::gyro)) {
    fit.refusal = "the log has no gyro";
    return fit;
  }
  double step = 0.0;
  const std::vector<Differences> all = differences_of(log, motion.rests, step);
  for (const TickSpan& rest : motion.rests) fit.rest += 1e-3 * static_cast<double>(rest.size());
  constexpr std::size_t blocks = 20, least = 100;
  if (all.size() < least) {
    fit.refusal = fmt::format("the mouse stands for {} rows, and must for {}, no motor driven", all.size(), least);
    return fit;
  }
  Differences sum;
  for (const Differences& one : all) sum += one;
  // Rounding adds the variance of an even distribution over a unit (Sheppard 1898).
  const auto without_rounding = [&](double deviation) {
    return std::sqrt(std::max(0.0, deviation * deviation - step * step / 12.0));
  };
  const double noise = without_rounding(sum.by_second());
  std::vector<double> without;
  for (const Differences& part : parts_of(all, blocks)) without.push_back(without_rounding((sum - part).by_second()));
  const double error = std::hypot(jackknife_error(without), sum.by_first() - sum.by_second());
  double squares = 0.0;
  constexpr std::size_t folds = 4;
  for (const Differences& part : parts_of(all, folds)) {
    const double other = (sum - part).by_second();
    squares += other > 0.0 ? std::pow(part.by_second() / other - 1.0, 2.0) : 0.0;
  }
  fit.missed = std::sqrt(squares / folds);
  fit.noise = said_within(noise, error, 0.5 * noise);
  if (!fit.noise.said())
    fit.refusal = noise > 0.0
                      ? fmt::format("its noise at rest comes out as {:.2g} +- {:.2g}: it is not white", noise, error)
                      : "it shows no noise at rest that is more than a unit of it";
  return fit;
}

}  // namespace labmouse
