#include "labmouse/lab/numbers/least_squares.hpp"

#include <cmath>

#include "labmouse/lab/numbers/statistics.hpp"

namespace labmouse {

void LeastSquares::add(std::span<const double> row, double value, double weight) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    for (std::size_t j = 0; j < row.size(); ++j) matrix_(i, j) += weight * row[i] * row[j];
    right_[i] += weight * row[i] * value;
  }
  values_ += weight * value * value;
}

LeastSquares& LeastSquares::operator+=(const LeastSquares& other) {
  for (std::size_t i = 0; i < right_.size(); ++i) {
    for (std::size_t j = 0; j < right_.size(); ++j) matrix_(i, j) += other.matrix_(i, j);
    right_[i] += other.right_[i];
  }
  values_ += other.values_;
  return *this;
}

LeastSquares& LeastSquares::operator-=(const LeastSquares& other) {
  for (std::size_t i = 0; i < right_.size(); ++i) {
    for (std::size_t j = 0; j < right_.size(); ++j) matrix_(i, j) -= other.matrix_(i, j);
    right_[i] -= other.right_[i];
  }
  values_ -= other.values_;
  return *this;
}

std::optional<std::vector<double>> LeastSquares::solution(std::span<const std::optional<double>> fixed) const {
  std::vector<double> unknowns(right_.size(), 0.0);
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < right_.size(); ++i)
    if (fixed[i])
      unknowns[i] = *fixed[i];
    else
      free.push_back(i);
  const std::size_t size = free.size();
  // Each unknown in a unit of its own, so that what is small beside 1 is nothing.
  std::vector<double> units(size), right(size);
  SquareMatrix rows(size);
  for (std::size_t i = 0; i < size; ++i) {
    if (!(matrix_(free[i], free[i]) > 0.0)) return std::nullopt;
    units[i] = 1.0 / std::sqrt(matrix_(free[i], free[i]));
  }
  for (std::size_t i = 0; i < size; ++i) {
    double rest = right_[free[i]];
    for (std::size_t j = 0; j < unknowns.size(); ++j) rest -= matrix_(free[i], j) * unknowns[j];
    right[i] = rest * units[i];
    for (std::size_t j = 0; j < size; ++j) rows(i, j) = matrix_(free[i], free[j]) * units[i] * units[j];
  }
  constexpr double nothing = 1e-10;
  for (std::size_t i = 0; i < size; ++i) {
    if (!(rows(i, i) > nothing)) return std::nullopt;
    for (std::size_t j = i + 1; j < size; ++j) {
      const double factor = rows(j, i) / rows(i, i);
      for (std::size_t k = i; k < size; ++k) rows(j, k) -= factor * rows(i, k);
      right[j] -= factor * right[i];
    }
  }
  for (std::size_t i = size; i-- > 0;) {
    for (std::size_t k = i + 1; k < size; ++k) right[i] -= rows(i, k) * right[k];
    right[i] /= rows(i, i);
  }
  for (std::size_t i = 0; i < size; ++i) unknowns[free[i]] = right[i] * units[i];
  return unknowns;
}

double LeastSquares::squares(std::span<const double> unknowns) const {
  double sum = values_;
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    sum -= 2.0 * unknowns[i] * right_[i];
    for (std::size_t j = 0; j < unknowns.size(); ++j) sum += unknowns[i] * unknowns[j] * matrix_(i, j);
  }
  return sum > 0.0 ? sum : 0.0;
}

double jackknife_error(std::span<const double> without_each) {
  const double middle = mean(without_each), count = static_cast<double>(without_each.size());
  double sum = 0.0;
  for (const double value : without_each) sum += (value - middle) * (value - middle);
  return std::sqrt(sum * (count - 1.0) / count);
}

}  // namespace labmouse
