#include "labmouse/lab/numbers/evolution.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace labmouse {
namespace {

/// A normal deviate by the polar method (Marsaglia and Bray 1964); the second one of the pair is not used.
double deviate(Rng& rng) {
  for (;;) {
    const double u = 2.0 * rng.unit() - 1.0, v = 2.0 * rng.unit() - 1.0;
    const double square = u * u + v * v;
    if (square > 0.0 && square < 1.0) return u * std::sqrt(-2.0 * std::log(square) / square);
  }
}

/// The number reflected at 0 and 1 into [0,1].
double reflected(double number) {
  const double in_period = std::abs(number - 2.0 * std::floor(number / 2.0));
  return std::min(1.0, in_period <= 1.0 ? in_period : 2.0 - in_period);
}

double length_of(const UnitPoint& vector) {
  return std::sqrt(std::inner_product(vector.begin(), vector.end(), vector.begin(), 0.0));
}

}  // namespace

int usual_population(std::size_t dimension) {
  return 4 + static_cast<int>(std::floor(3.0 * std::log(static_cast<double>(dimension))));
}

Evolution::Constants Evolution::constants_of(std::size_t dimension, int population) {
  const double n = static_cast<double>(dimension);
  Constants constants;
  const int parents = population / 2;
  for (int rank = 1; rank <= parents; ++rank)
    constants.weights.push_back(std::log((population + 1) / 2.0) - std::log(static_cast<double>(rank)));
  const double sum = std::accumulate(constants.weights.begin(), constants.weights.end(), 0.0);
  double squares = 0.0;
  for (double& weight : constants.weights) {
    weight /= sum;
    squares += weight * weight;
  }
  const double mu = 1.0 / squares;
  constants.effective = mu;
  constants.path_rate = (mu + 2.0) / (n + mu + 5.0);
  constants.damping = 1.0 + 2.0 * std::max(0.0, std::sqrt((mu - 1.0) / (n + 1.0)) - 1.0) + constants.path_rate;
  constants.shape_path_rate = (4.0 + mu / n) / (n + 4.0 + 2.0 * mu / n);
  constants.rank_one = 2.0 / ((n + 1.3) * (n + 1.3) + mu);
  constants.rank_mu = std::min(1.0 - constants.rank_one, 2.0 * (mu - 2.0 + 1.0 / mu) / ((n + 2.0) * (n + 2.0) + mu));
  constants.usual_length = std::sqrt(n) * (1.0 - 1.0 / (4.0 * n) + 1.0 / (21.0 * n * n));
  return constants;
}

Evolution::Evolution(const EvolutionOrder& order)
    : dimension_(order.start.size()),
      population_(order.population > 0 ? order.population : usual_population(dimension_)),
      constants_(constants_of(dimension_, population_)),
      rng_(order.seed),
      mean_(order.start),
      step_(order.step),
      path_(dimension_, 0.0),
      shape_path_(dimension_, 0.0),
      covariance_(SquareMatrix::identity(dimension_)),
      axes_{std::vector<double>(dimension_, 1.0), SquareMatrix::identity(dimension_)} {
  assert(dimension_ >= 1 && population_ >= 2 && step_ > 0.0);
}

std::vector<UnitPoint> Evolution::ask() {
  steps_.clear();
  std::vector<UnitPoint> points;
  for (int i = 0; i < population_; ++i) {
    steps_.push_back(thrown_step());
    UnitPoint point(dimension_);
    for (std::size_t d = 0; d < dimension_; ++d) point[d] = reflected(mean_[d] + step_ * steps_.back()[d]);
    points.push_back(std::move(point));
  }
  return points;
}

/// A sample of the distribution with unit step size: a normal deviate along each principal axis.
UnitPoint Evolution::thrown_step() {
  UnitPoint step(dimension_, 0.0);
  for (std::size_t axis = 0; axis < dimension_; ++axis) {
    const double along = axes_.values[axis] * deviate(rng_);
    for (std::size_t d = 0; d < dimension_; ++d) step[d] += along * axes_.vectors(d, axis);
  }
  return step;
}

void Evolution::tell(std::span<const double> values) {
  assert(values.size() == steps_.size());
  std::vector<std::size_t> ranked(values.size());
  std::iota(ranked.begin(), ranked.end(), std::size_t{0});
  std::stable_sort(ranked.begin(), ranked.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  const UnitPoint move = weighted_sum(ranked);
  for (std::size_t d = 0; d < dimension_; ++d) mean_[d] += step_ * move[d];
  const bool path_runs = advance_paths(move);
  learn_shape(ranked, path_runs);
  const double growth = constants_.path_rate / constants_.damping * (length_of(path_) / constants_.usual_length - 1.0);
  // A step longer than the cube has no use: reflection brings it back.
  step_ = std::min(1.0, step_ * std::exp(std::min(1.0, growth)));
}

/// The weighted mean of the better half's steps.
UnitPoint Evolution::weighted_sum(std::span<const std::size_t> ranked) const {
  UnitPoint sum(dimension_, 0.0);
  for (std::size_t rank = 0; rank < constants_.weights.size(); ++rank)
    for (std::size_t d = 0; d < dimension_; ++d) sum[d] += constants_.weights[rank] * steps_[ranked[rank]][d];
  return sum;
}

/// The whitened step: covariance^(-1/2) step.
UnitPoint Evolution::whitened(const UnitPoint& step) const {
  UnitPoint white(dimension_, 0.0);
  for (std::size_t axis = 0; axis < dimension_; ++axis) {
    double along = 0.0;
    for (std::size_t d = 0; d < dimension_; ++d) along += axes_.vectors(d, axis) * step[d];
    for (std::size_t d = 0; d < dimension_; ++d) white[d] += along / axes_.values[axis] * axes_.vectors(d, axis);
  }
  return white;
}

/// Adds the mean's move to both paths. Where the path of the step size is long, it adds nothing to the shape's path and
/// returns false: the step size has to grow, not the covariance (h_sigma of the tutorial).
bool Evolution::advance_paths(const UnitPoint& move) {
  const UnitPoint white = whitened(move);
  const double rate = constants_.path_rate, shape_rate = constants_.shape_path_rate;
  for (std::size_t d = 0; d < dimension_; ++d)
    path_[d] = (1.0 - rate) * path_[d] + std::sqrt(rate * (2.0 - rate) * constants_.effective) * white[d];
  path_age_ *= (1.0 - rate) * (1.0 - rate);
  const double n = static_cast<double>(dimension_);
  const bool runs = length_of(path_) / std::sqrt(1.0 - path_age_) < (1.4 + 2.0 / (n + 1.0)) * constants_.usual_length;
  const double gain = runs ? std::sqrt(shape_rate * (2.0 - shape_rate) * constants_.effective) : 0.0;
  for (std::size_t d = 0; d < dimension_; ++d) shape_path_[d] = (1.0 - shape_rate) * shape_path_[d] + gain * move[d];
  return runs;
}

void Evolution::learn_shape(std::span<const std::size_t> ranked, bool path_runs) {
  const double one = constants_.rank_one, mu = constants_.rank_mu, rate = constants_.shape_path_rate;
  const double kept = 1.0 - one - mu + (path_runs ? 0.0 : one * rate * (2.0 - rate));
  for (std::size_t row = 0; row < dimension_; ++row)
    for (std::size_t column = 0; column <= row; ++column) {
      double of_steps = 0.0;
      for (std::size_t rank = 0; rank < constants_.weights.size(); ++rank) {
        const UnitPoint& step = steps_[ranked[rank]];
        of_steps += constants_.weights[rank] * step[row] * step[column];
      }
      covariance_(row, column) =
          kept * covariance_(row, column) + one * shape_path_[row] * shape_path_[column] + mu * of_steps;
      covariance_(column, row) = covariance_(row, column);
    }
  axes_ = eigenvectors_of(covariance_);
  const double largest = *std::max_element(axes_.values.begin(), axes_.values.end());
  // Rounding may make a small eigenvalue zero or negative.
  for (double& value : axes_.values) value = std::sqrt(std::max(value, 1e-14 * largest));
}

}  // namespace labmouse
