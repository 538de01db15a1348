// Quantiles of Student's t distribution.
#pragma once

namespace labmouse {

/// The 97.5 % quantile of Student's t distribution, with an error of about 2e-7. It uses only + - * /, so results have
/// the same bits on every platform.
/// @param freedom Degrees of freedom, at least 1.
double student_quantile(int freedom);

}  // namespace labmouse
