// CMA-ES: minimizes a black-box function, whose value can only be measured point by point.
//
// Method: each generation samples points from a normal distribution, ranks them by their measured values, and moves the
// distribution's mean to the weighted mean of the better half. Its step size grows while successive moves point the
// same way and shrinks while they cancel (cumulation); its shape, the covariance matrix, learns from the better half
// (rank-mu update) and from the path of the mean (rank-one update). Only the order of the values counts.
// Source: Hansen, "The CMA Evolution Strategy: A Tutorial" (arXiv 1604.00772, 2016), with its standard constants and
// positive weights.
// Limits: learning the covariance of n parameters takes about 10 n^2 measurements. For parameters with few possible
// values, learning stops once the step is shorter than the distance between two values. Sampling and the step size use
// std::log and std::exp, whose last bit may differ between platforms. So the path of a search may differ, but the value
// measured at a point does not.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "labmouse/chance/rng.hpp"
#include "labmouse/lab/numbers/eigenvectors.hpp"

namespace labmouse {

using UnitPoint = std::vector<double>;

struct EvolutionOrder {
  UnitPoint start;     ///< in the unit cube; 1 to 20 numbers
  double step = 0.2;   ///< initial standard deviation of each number, as a share of its range
  int population = 0;  ///< points a generation, at least 2; 0 takes usual_population
  std::uint64_t seed = 1;
};

/// 4 + 3 ln(dimension), rounded down.
int usual_population(std::size_t dimension);

/// One search in the unit cube [0,1]^n. Samples outside are reflected at its sides, as often as needed.
class Evolution {
 public:
  explicit Evolution(const EvolutionOrder& order);

  /// The points of the next generation. Another call before tell() draws new points.
  std::vector<UnitPoint> ask();
  /// Reports the values measured at the points of the last ask(), in their order. Lower is better; ties keep their
  /// order.
  void tell(std::span<const double> values);

  int population() const { return population_; }
  /// The present step size, as a share of the ranges.
  double step() const { return step_; }

 private:
  /// Weights of the better half and the rates of learning, all of them functions of dimension and population.
  struct Constants {
    std::vector<double> weights;
    double effective = 0.0;        ///< mu_eff: variance-effective number of parents
    double path_rate = 0.0;        ///< c_sigma, of the path of the step size
    double damping = 0.0;          ///< d_sigma
    double shape_path_rate = 0.0;  ///< c_c, of the path of the shape
    double rank_one = 0.0;         ///< c_1
    double rank_mu = 0.0;          ///< c_mu
    double usual_length = 0.0;     ///< expected length of a vector of standard normal deviates
  };
  static Constants constants_of(std::size_t dimension, int population);

  UnitPoint thrown_step();
  UnitPoint weighted_sum(std::span<const std::size_t> ranked) const;
  UnitPoint whitened(const UnitPoint& step) const;
  bool advance_paths(const UnitPoint& move);
  void learn_shape(std::span<const std::size_t> ranked, bool path_runs);

  std::size_t dimension_;
  int population_;
  Constants constants_;
  Rng rng_;
  UnitPoint mean_;  ///< not reflected: may lie outside of the cube
  double step_;
  UnitPoint path_, shape_path_;
  double path_age_ = 1.0;  ///< (1 - c_sigma)^(2 generations): corrects for the paths' start at zero
  SquareMatrix covariance_;
  Eigenvectors axes_;             ///< of the covariance; the values are standard deviations
  std::vector<UnitPoint> steps_;  ///< of the last ask(), not yet scaled by the step size nor shifted by the mean
};

}  // namespace labmouse
