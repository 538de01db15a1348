// Least squares for a few unknowns, and errors that hold where residuals depend on their neighbours.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "labmouse/lab/numbers/eigenvectors.hpp"

namespace labmouse {

/// The sums of a linear problem: rows of numbers that, each times its unknown, should add up to a value. Sums of parts
/// of the rows can be added and taken away.
class LeastSquares {
 public:
  explicit LeastSquares(std::size_t unknowns) : matrix_(unknowns), right_(unknowns, 0.0) {}

  void add(std::span<const double> row, double value, double weight = 1.0);
  LeastSquares& operator+=(const LeastSquares& other);
  LeastSquares& operator-=(const LeastSquares& other);

  /// The unknowns; those with a number in `fixed`, which has a place for each, keep that. Nothing where the rows do not
  /// tell the others apart.
  std::optional<std::vector<double>> solution(std::span<const std::optional<double>> fixed) const;
  /// The weighted sum of the squares that these unknowns leave.
  double squares(std::span<const double> unknowns) const;

 private:
  SquareMatrix matrix_;
  std::vector<double> right_;
  double values_ = 0.0;  ///< sum of their squares
};

/// The standard error of an estimate from what it is without each of several parts of the data (jackknife, Quenouille
/// 1949, Tukey 1958). Where a part is a stretch longer than residuals remember, these may depend on each other. At
/// least two parts.
double jackknife_error(std::span<const double> without_each);

}  // namespace labmouse
