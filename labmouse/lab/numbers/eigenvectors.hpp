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

/// Column i of `vectors` has length 1 and belongs to values[i]; the columns are at right angles. In no order.
struct Eigenvectors {
  std::vector<double> values;
  SquareMatrix vectors;
};

/// Of a symmetric matrix, by cyclic rotations (Jacobi 1846): plain, and as exact as any method for a side of 20 or
/// less. Uses + - * / and sqrt alone, so it gives the same bits on every platform.
Eigenvectors eigenvectors_of(SquareMatrix matrix);

}  // namespace labmouse
