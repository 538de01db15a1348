// Eigenvectors of small symmetric matrices.
#pragma once

#include <cstddef>
#include <vector>

namespace labmouse {

/// A square matrix, row by row.
class SquareMatrix {
 public:
  explicit SquareMatrix(std::size_t side) : side_(side), values_(side * side, 0.0) {}

  static SquareMatrix identity(std::size_t side) {
    SquareMatrix matrix(side);
    for (std::size_t i = 0; i < side; ++i) matrix(i, i) = 1.0;
    return matrix;
  }

  std::size_t side() const { return side_; }
  double& operator()(std::size_t row, std::size_t column) { return values_[row * side_ + column]; }
  double operator()(std::size_t row, std::size_t column) const { return values_[row * side_ + column]; }

 private:
  std::size_t side_;
  std::vector<double> values_;
};

/// Eigenvalues and eigenvectors, not sorted. Column i of `vectors` is the unit eigenvector of values[i]; the columns
/// are orthogonal.
struct Eigenvectors {
  std::vector<double> values;
  SquareMatrix vectors;
};

/// Eigenvectors of a symmetric matrix, by the cyclic Jacobi method (1846), which is accurate enough for a side of 20 or
/// less. It uses only + - * / and sqrt, so results have the same bits on every platform.
Eigenvectors eigenvectors_of(SquareMatrix matrix);

}  // namespace labmouse
