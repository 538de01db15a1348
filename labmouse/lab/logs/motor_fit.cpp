#include "labmouse/lab/logs/motor_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <vector>

#include "labmouse/hardware/sense.hpp"
#include "labmouse/lab/numbers/least_squares.hpp"

namespace labmouse {
namespace {

constexpr std::size_t most_blocks = 20, least_blocks = 6;
/// What is less sure than that is not said, as a share; and as a duty, for a dead zone may be 0.
constexpr double sure = 0.25, sure_duty = 0.03, sure_share = 0.1;
/// What is left counts as more than noise from so many times of it on.
constexpr double much = 3.0;

using Fixed = std::array<std::optional<double>, motor_unknowns>;
using Answer = std::vector<double>;

// A rate comes nearer to a steady one by 1 - exp(-tick/T) a tick.
double time_of(double share) { return -tick_seconds / std::log1p(-share * tick_seconds); }
double share_of(double time) { return -std::expm1(-tick_seconds / time) / tick_seconds; }

/// What an answer says: gain, time, dead zone, what is mixed in, and what takes more of the duty.
using MotorNumbers = std::array<double, 5>;
MotorNumbers numbers_of(const Answer& answer) {
  return {answer[by_duty] / answer[by_rate], time_of(answer[by_rate]), answer[by_friction] / answer[by_duty],
          answer[by_other] / answer[by_duty], answer[by_taken] / answer[by_duty]};
}

/// A model's answer to all blocks of stretches, with its errors, and what it misses on blocks left out.
struct ModelFit {
  Answer answer;
  MotorNumbers numbers{}, errors{};
  std::vector<double> missed;  ///< by block, squares of rates
  double all_missed = 0.0;
};

class MotorBlocks {
 public:
  MotorBlocks(const AxisLog& log, const std::vector<TickSpan>& stretches) {
    const std::size_t count = std::min(most_blocks, stretches.size());
    problems_.assign(count, LeastSquares(motor_unknowns));
    curves_.resize(count);
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const std::size_t block = i * count / stretches.size();
      curves_[block].emplace_back(log, stretches[i]);
      curves_[block].back().add_to(problems_[block]);
      const RateSquares changes = curves_[block].back().left_by(Answer(motor_unknowns, 0.0));
      changes_ += changes.sum;
      ticks_ += changes.count;
    }
    for (const LeastSquares& problem : problems_) all_ += problem;
  }

  std::size_t count() const { return problems_.size(); }

  /// Nothing where the log does not determine it, or says that a motor brakes by being driven.
  std::optional<ModelFit> fit(const Fixed& fixed) const {
    ModelFit fit;
    const auto answer = all_.solution(fixed);
    if (!answer || !is_motor(*answer)) return std::nullopt;
    fit.answer = *answer;
    fit.numbers = numbers_of(*answer);
    std::array<std::vector<double>, std::tuple_size_v<MotorNumbers>> without;
    for (std::size_t block = 0; block < count(); ++block) {
      LeastSquares rest = all_;
      rest -= problems_[block];
      const auto other = rest.solution(fixed);
      if (!other || !is_motor(*other)) return std::nullopt;
      const MotorNumbers numbers = numbers_of(*other);
      for (std::size_t i = 0; i < numbers.size(); ++i) without[i].push_back(numbers[i]);
      double missed = 0.0;
      for (const StretchCurves& curves : curves_[block]) missed += curves.left_by(*other).sum;
      fit.missed.push_back(missed);
      fit.all_missed += missed;
    }
    for (std::size_t i = 0; i < without.size(); ++i) fit.errors[i] = jackknife_error(without[i]);
    return fit;
  }
  double rms(double squares) const { return std::sqrt(squares / static_cast<double>(ticks_)); }
  /// The rates themselves, without those that stretches begin with: what there is to explain.
  double changes() const { return rms(changes_); }

 private:
  static bool is_motor(const Answer& answer) {
    return answer[by_duty] > 0.0 && answer[by_rate] > 0.0 && answer[by_rate] < 1.0 / tick_seconds;
  }

  std::vector<LeastSquares> problems_;
  std::vector<std::vector<StretchCurves>> curves_;
  LeastSquares all_{motor_unknowns};
  std::size_t ticks_ = 0;
  double changes_ = 0.0;
};

bool is_sure(const ModelFit& fit, std::size_t number) { return fit.errors[number] <= sure * fit.numbers[number]; }

/// The first of the models that the log is sure of: with a time of its own, or with the base's, each with what takes of
/// the duty as the log says, or as the base does.
struct ChosenFit {
  Fixed fixed{};
  std::optional<ModelFit> fit;
};
ChosenFit choose(const MotorBlocks& blocks, const MotorAxis& base, double factor) {
  ChosenFit chosen;
  for (const auto& time : {std::optional<double>(), std::optional<double>(share_of(base.time))}) {
    chosen.fixed = Fixed{};
    chosen.fixed[by_lag] = chosen.fixed[by_drag] = 0.0;
    chosen.fixed[by_rate] = time;
    chosen.fit = blocks.fit(chosen.fixed);
    if (!chosen.fit || !(chosen.fit->errors[4] < factor)) {
      chosen.fixed[by_taken] = 0.0;
      chosen.fit = blocks.fit(chosen.fixed);
    }
    if (chosen.fit && is_sure(*chosen.fit, 0) && is_sure(*chosen.fit, 1)) return chosen;
  }
  return chosen;
}

/// Adds to the errors what models of the next order would change, if they fit better; returns what the best one misses.
double widen_by_models(const MotorBlocks& blocks, const ChosenFit& chosen, MotorFit& result, MotorNumbers& errors) {
  double least = chosen.fit->all_missed;
  for (const MotorUnknown more : {by_lag, by_drag}) {
    Fixed fixed = chosen.fixed;
    fixed[more] = std::nullopt;
    const auto model = blocks.fit(fixed);
    if (!model || !leaves_less(model->missed, chosen.fit->missed)) continue;
    least = std::min(least, model->all_missed);
    for (std::size_t i = 0; i < errors.size(); ++i)
      errors[i] = std::hypot(errors[i], model->numbers[i] - chosen.fit->numbers[i]);
    const double size = model->answer[more] / model->answer[by_duty];
    (more == by_lag ? result.lag : result.drag) = more == by_lag ? size : size * result.peak * result.peak;
  }
  return least;
}

std::string reason_of(const MotorFit& fit, const MotorNumbers& numbers, const MotorNumbers& errors) {
  const std::string unsure = fmt::format("its gain comes out as {:.4g} +- {:.2g}", numbers[0], errors[0]);
  if (fit.lag != 0.0)
    return fmt::format("{}: it is no motor of the first order, but lags by {:.1f} ms more", unsure, 1e3 * fit.lag);
  if (fit.drag != 0.0) return fmt::format("{}: something brakes it more, the faster it goes", unsure);
  if (fit.noise > 0.0 && fit.missed > much * fit.noise)
    return fmt::format("{}: it misses stretches left out by {:.0f} times the noise", unsure, fit.missed / fit.noise);
  return unsure + ": speeds and duties differ too little";
}

}  // namespace

MotorFit fit_motor(const AxisLog& log, const MotorAxis& base) {
  MotorFit result;
  for (const double rate : log.rate) result.peak = std::max(result.peak, std::abs(rate));
  // Nearer to rest a body's friction is another.
  const double slow = std::max(0.05 * result.peak, 0.006 * base.gain);
  const std::vector<TickSpan> stretches = one_way_stretches(log, slow);
  result.stretches = stretches.size();
  if (stretches.size() < least_blocks) {
    result.refusal =
        fmt::format("it moves one way long enough {} times, and must {} times", stretches.size(), least_blocks);
    return result;
  }
  const MotorBlocks blocks(log, stretches);
  const ChosenFit chosen = choose(blocks, base, log.factor);
  if (!chosen.fit) {
    result.refusal = "its speeds do not follow from its duties: are these the right columns, with the right signs?";
    return result;
  }
  const MotorNumbers& numbers = chosen.fit->numbers;
  MotorNumbers errors = chosen.fit->errors;
  result.time_known = !chosen.fixed[by_rate].has_value();
  result.missed = blocks.rms(chosen.fit->all_missed);
  result.noise = noise_of(log, stretches);
  const double left = blocks.rms(widen_by_models(blocks, chosen, result, errors));
  // What no model explains could as well be of what was fitted.
  result.changes = blocks.changes();
  if (left > much * result.noise)
    for (std::size_t i = 0; i < errors.size(); ++i)
      errors[i] = std::hypot(errors[i], numbers[i] * left / result.changes);
  result.gain = said_within(numbers[0], errors[0], sure * numbers[0]);
  if (result.time_known) result.time = said_within(numbers[1], errors[1], sure * numbers[1]);
  result.dead_zone = said_within(std::max(0.0, numbers[2]), errors[2], sure_duty);
  result.mixed = said_within(numbers[3], errors[3], sure_share);
  result.taking = said_within(std::max(0.0, log.factor + numbers[4]), errors[4], log.factor);
  if (!result.gain.said() || (result.time_known && !result.time.said())) {
    result.refusal = reason_of(result, numbers, errors);
    result.gain.error = result.time.error = result.dead_zone.error = 0.0;
    result.mixed.error = result.taking.error = 0.0;
  }
  return result;
}

}  // namespace labmouse
