// Quantiles of Student's t distribution.
#pragma once

namespace labmouse {

/// The 97.5 % quantile of Student's t distribution with that many degrees of freedom, which must be at least 1; to
/// about 2e-7. Sums and products alone, so that it has the same bits on every platform.
double student_quantile(int freedom);

}  // namespace labmouse
