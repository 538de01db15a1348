#include "labmouse/lab/numbers/eigenvectors.hpp"

#include <cmath>

namespace labmouse {
namespace {

/// Cosine and sine of the rotation that makes element (p,q) zero.
struct Rotation {
  double cosine, sine;
};

Rotation rotation_for(const SquareMatrix& matrix, std::size_t p, std::size_t q) {
  const double theta = (matrix(q, q) - matrix(p, p)) / (2.0 * matrix(p, q));
  // Takes the smaller of the two tangents, a rotation by at most 45 degrees; the larger one would also swap the axes.
  const double tangent = (theta < 0.0 ? -1.0 : 1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
  const double cosine = 1.0 / std::sqrt(tangent * tangent + 1.0);
  return {cosine, tangent * cosine};
}

void rotate(double& a, double& b, Rotation by) {
  const double old = a;
  a = by.cosine * old - by.sine * b;
  b = by.sine * old + by.cosine * b;
}

void rotate_columns(SquareMatrix& matrix, std::size_t p, std::size_t q, Rotation by) {
  for (std::size_t row = 0; row < matrix.side(); ++row) rotate(matrix(row, p), matrix(row, q), by);
}

void rotate_rows(SquareMatrix& matrix, std::size_t p, std::size_t q, Rotation by) {
  for (std::size_t column = 0; column < matrix.side(); ++column) rotate(matrix(p, column), matrix(q, column), by);
}

/// Whether all elements off the diagonal are zero up to rounding errors.
bool is_diagonal(const SquareMatrix& matrix) {
  double beside = 0.0, diagonal = 0.0;
  for (std::size_t row = 0; row < matrix.side(); ++row)
    for (std::size_t column = 0; column < matrix.side(); ++column)
      (row == column ? diagonal : beside) += matrix(row, column) * matrix(row, column);
  return beside <= 1e-30 * diagonal;
}

}  // namespace

Eigenvectors eigenvectors_of(SquareMatrix matrix) {
  constexpr int most_rounds = 50;  // it converges quadratically: six to ten are usual
  const std::size_t side = matrix.side();
  Eigenvectors result{std::vector<double>(side), SquareMatrix::identity(side)};
  for (int round = 0; round < most_rounds && !is_diagonal(matrix); ++round)
    for (std::size_t p = 0; p < side; ++p)
      for (std::size_t q = p + 1; q < side; ++q) {
        if (matrix(p, q) == 0.0) continue;
        const Rotation by = rotation_for(matrix, p, q);
        rotate_columns(matrix, p, q, by);
        rotate_rows(matrix, p, q, by);
        rotate_columns(result.vectors, p, q, by);
      }
  for (std::size_t i = 0; i < side; ++i) result.values[i] = matrix(i, i);
  return result;
}

}  // namespace labmouse
