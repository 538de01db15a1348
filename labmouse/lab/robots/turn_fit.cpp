#include "labmouse/lab/robots/turn_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace labmouse {
namespace {

constexpr std::size_t most_limits = 4;
constexpr double good = 5e-4;
constexpr int rounds = 60;

/// Which of the limits are fitted, and their values: lateral acceleration, yaw acceleration, yaw speed, yaw jerk.
using Values = std::array<double, most_limits>;
using Chosen = std::vector<std::size_t>;

CurveLimits limits_of(const Values& values) { return {values[0], values[1], values[2], values[3]}; }

/// Relative errors, two by turn: of the curve's size, and of the whole turn's time.
using Errors = std::vector<double>;

Errors errors_of(std::span<const KnownTurn> turns, double cell, const Values& values) {
  Errors errors;
  for (const KnownTurn& turn : turns) {
    errors.insert(errors.end(), 2, 0.0);
    if (turn.speed <= 0.0) continue;
    const TurnShape shape = shape_at(turn.turn, turn.speed, limits_of(values), turn.wide ? 2.0 * cell : cell);
    if (turn.aside > 0.0) errors[errors.size() - 2] = width_of(shape) / turn.aside - 1.0;
    // The straights about 180 may be of any length.
    const bool any_length = turn.turn == Turn::f180;
    if (turn.milliseconds <= 0.0 || (any_length && turn.before <= 0.0)) continue;
    const double whole = any_length ? shape.length + 2.0 * turn.before : shape.whole();
    errors.back() = whole / turn.speed * 1e3 / turn.milliseconds - 1.0;
  }
  return errors;
}

double square_sum(const Errors& errors) {
  double sum = 0.0;
  for (const double error : errors) sum += error * error;
  return sum;
}
double largest(const Errors& errors) {
  double most = 0.0;
  for (const double error : errors) most = std::max(most, std::abs(error));
  return most;
}

/// Solves a small system with a positive definite matrix, whose right side is the last column.
std::array<double, most_limits> solved(std::array<std::array<double, most_limits + 1>, most_limits> rows,
                                       std::size_t size) {
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = i + 1; j < size; ++j) {
      const double factor = rows[j][i] / rows[i][i];
      for (std::size_t k = i; k <= size; ++k) rows[j][k] -= factor * rows[i][k];
    }
  std::array<double, most_limits> result{};
  for (std::size_t i = size; i-- > 0;) {
    double rest = rows[i][size];
    for (std::size_t k = i + 1; k < size; ++k) rest -= rows[i][k] * result[k];
    result[i] = rest / rows[i][i];
  }
  return result;
}

struct FitTrial {
  Values values{};
  Errors errors;
  double sum = 1e300;
};

/// One descent. Limits are changed by shares of themselves.
class Descent {
 public:
  Descent(std::span<const KnownTurn> turns, double cell, const Chosen& chosen)
      : turns_(turns), cell_(cell), chosen_(chosen) {}

  FitTrial from(const Values& start) {
    FitTrial best = at(start);
    double damping = 1e-2;
    for (int round = 0; round < rounds && best.sum > 1e-20 && damping < 1e12; ++round) {
      const FitTrial next = at(stepped(best, damping));
      const bool better = next.sum < best.sum;
      damping *= better ? 0.2 : 8.0;
      if (better) best = next;
    }
    return best;
  }

 private:
  FitTrial at(const Values& values) const {
    FitTrial trial{values, errors_of(turns_, cell_, values), 0.0};
    trial.sum = square_sum(trial.errors);
    return trial;
  }

  Values stepped(const FitTrial& here, double damping) const {
    constexpr double share = 1e-6;
    std::vector<Errors> slopes;
    for (const std::size_t limit : chosen_) {
      Values other = here.values;
      other[limit] *= 1.0 + share;
      Errors slope = errors_of(turns_, cell_, other);
      for (std::size_t i = 0; i < slope.size(); ++i) slope[i] = (slope[i] - here.errors[i]) / share;
      slopes.push_back(std::move(slope));
    }
    std::array<std::array<double, most_limits + 1>, most_limits> rows{};
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      for (std::size_t j = 0; j < slopes.size(); ++j)
        for (std::size_t k = 0; k < here.errors.size(); ++k) rows[i][j] += slopes[i][k] * slopes[j][k];
      for (std::size_t k = 0; k < here.errors.size(); ++k) rows[i][slopes.size()] -= slopes[i][k] * here.errors[k];
      rows[i][i] += damping * rows[i][i] + 1e-12;
    }
    const auto change = solved(rows, slopes.size());
    Values next = here.values;
    for (std::size_t i = 0; i < chosen_.size(); ++i) next[chosen_[i]] *= std::clamp(1.0 + change[i], 0.5, 2.0);
    return next;
  }

  std::span<const KnownTurn> turns_;
  double cell_;
  const Chosen& chosen_;
};

/// The best of the descents from a grid of starts.
FitTrial best_of(std::span<const KnownTurn> turns, double cell, const Chosen& chosen) {
  const auto fits = [&](std::size_t limit) { return std::find(chosen.begin(), chosen.end(), limit) != chosen.end(); };
  double fastest = 0.0;
  for (const KnownTurn& turn : turns) fastest = std::max(fastest, turn.speed);
  Descent descent(turns, cell, chosen);
  FitTrial best;
  for (const double lateral : {6.0, 12.0, 24.0})
    for (const double acceleration : {30.0, 100.0, 300.0, 1000.0})
      for (const double speed : {4.0, 9.0, 20.0})
        for (const double jerk : {15.0, 60.0}) {
          const bool repeats = (!fits(2) && speed != 4.0) || (!fits(3) && jerk != 15.0);
          if (repeats || best.sum < 1e-18) continue;
          const Values start = {lateral * fastest, acceleration, fits(2) ? speed : 0.0,
                                fits(3) ? jerk * acceleration : 0.0};
          if (FitTrial trial = descent.from(start); trial.sum < best.sum) best = std::move(trial);
        }
  return best;
}

/// Whether some figure changes where a limit is higher.
bool is_reached(std::span<const KnownTurn> turns, double cell, const FitTrial& fit, std::size_t limit) {
  Values higher = fit.values;
  higher[limit] *= 1.01;
  const Errors errors = errors_of(turns, cell, higher);
  for (std::size_t i = 0; i < errors.size(); ++i)
    if (std::abs(errors[i] - fit.errors[i]) > 1e-9) return true;
  return false;
}

int figures_of(std::span<const KnownTurn> turns) {
  int count = 0;
  for (const KnownTurn& turn : turns)
    if (turn.speed > 0.0)
      count += (turn.aside > 0.0 ? 1 : 0) +
               (turn.milliseconds > 0.0 && (turn.turn != Turn::f180 || turn.before > 0.0) ? 1 : 0);
  return count;
}

}  // namespace

TurnFit fit_turns(std::span<const KnownTurn> turns, double cell) {
  TurnFit result;
  result.errors.assign(turns.size(), 0.0);
  result.figures = figures_of(turns);
  if (result.figures == 0) return result;
  FitTrial best;
  Chosen limits;
  for (const Chosen& chosen : {Chosen{0, 1}, Chosen{0, 1, 2}, Chosen{0, 1, 3}, Chosen{0, 1, 2, 3}}) {
    FitTrial trial = best_of(turns, cell, chosen);
    const bool enough = largest(trial.errors) <= good;
    if (trial.sum < best.sum) best = std::move(trial), limits = chosen;
    if (enough) break;
  }
  // Of absurd turns every descent may leave the range of numbers.
  if (best.errors.empty()) return result;
  result.limits = limits_of(best.values);
  result.numbers = static_cast<int>(limits.size());
  result.reaches_lateral = is_reached(turns, cell, best, 0);
  result.reaches_acceleration = is_reached(turns, cell, best, 1);
  result.reaches_speed = best.values[2] > 0.0 && is_reached(turns, cell, best, 2);
  result.reaches_jerk = best.values[3] > 0.0 && is_reached(turns, cell, best, 3);
  for (std::size_t i = 0; i < turns.size(); ++i)
    result.errors[i] = std::max(std::abs(best.errors[2 * i]), std::abs(best.errors[2 * i + 1]));
  return result;
}

}  // namespace labmouse
