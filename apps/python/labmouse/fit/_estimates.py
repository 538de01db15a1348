"""Estimates with standard errors, and linear least squares with a jackknife."""

import dataclasses
import math
from dataclasses import dataclass
from importlib import import_module
from typing import Any, Optional

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Estimate:
    """A number and its standard error, in the same unit. An error of 0 means that there is no estimate.

    freedom: degrees of freedom of the error; few for a short log. positive: the number cannot be 0 or below, so its
    logarithm has a symmetric interval. unsure: why the number is not reliable, or ''.
    """

    value: float = 0.0
    error: float = 0.0
    freedom: float = math.inf
    positive: bool = False
    unsure: str = ""

    @property
    def known(self) -> bool:
        """Whether there is an estimate."""
        return self.error > 0.0

    @property
    def sure(self) -> bool:
        """Whether there is a reliable estimate."""
        return self.known and not self.unsure

    @property
    def interval(self) -> tuple[float, float]:
        """The 95 % interval, by Student's t distribution; without an estimate, (nan, nan)."""
        if not self.known:
            return math.nan, math.nan
        stats: Any = import_module("scipy.stats")
        width = float(stats.t.ppf(0.975, self.freedom)) * self.error
        if self.positive and self.value > 0.0:
            factor = math.exp(min(700.0, width / self.value))
            return self.value / factor, self.value * factor
        return self.value - width, self.value + width

    def scaled(self, factor: float) -> "Estimate":
        """The same number in another unit."""
        return dataclasses.replace(self, value=factor * self.value, error=abs(factor) * self.error)

    def with_error(self, error: float) -> "Estimate":
        """With a further, independent standard error, known exactly. Degrees of freedom: Welch 1947, Satterthwaite 1946."""
        if not self.known:
            return self
        total = math.hypot(self.error, error)
        return dataclasses.replace(self, error=total, freedom=self.freedom * (total / self.error) ** 4)


def within(value: float, error: float, most: float, why: str, freedom: float = math.inf, positive: bool = False) -> Estimate:
    """An estimate that is unsure, with the reason `why`, if its error is above `most`."""
    unsure = "" if error <= most else why
    return Estimate(float(value), float(error) if math.isfinite(error) else 0.0, freedom, positive, unsure)


def jackknife(without: Any) -> Any:
    """Standard errors by the delete-one-block jackknife: `without[i]` is the estimate without block i of the data.

    Residuals may be correlated within a block. Source: Quenouille 1949, Tukey 1958.
    """
    values = np.asarray(without, dtype=float)
    count = len(values)
    return np.sqrt(((values - values.mean(axis=0)) ** 2).sum(axis=0) * (count - 1.0) / count)


def fits_better(one: Array, other: Array) -> bool:
    """Whether model `one` predicts better than model `other`, by their squared cross-validation errors per block.

    It does if its sum is less than half of the other's, or less than 0.9 of it with a difference above 2.5 standard
    deviations.
    """
    count, gain = len(one), float(other.sum() - one.sum())
    deviation = np.sqrt(max(0.0, float(((other - one) ** 2).sum()) - gain * gain / count) * count / (count - 1.0))
    left, left_by_other = float(one.sum()), float(other.sum())
    return left < 0.5 * left_by_other or (left < 0.9 * left_by_other and gain > 2.5 * deviation)


def robust_weights(rows: Array, values: Array, floor: float) -> Array:
    """Weights of Huber's loss for n equations, shape (n,): 1 near the fit, less for outliers.

    rows: (n, k), values: (n,). Outliers have residuals beyond 3 standard deviations (estimated by the median) and
    beyond `floor`. Without outliers all weights are 1, which is ordinary least squares. Source: Huber 1964.
    """
    start = np.linalg.lstsq(rows, values, rcond=None)[0]
    scale = max(floor, 3.0 * 1.4826 * float(np.median(np.abs(values - rows @ start))))
    if scale <= 0.0 or np.abs(values - rows @ start).max() <= scale:
        return np.ones(len(values))
    optimize: Any = import_module("scipy.optimize")
    answer = optimize.least_squares(lambda x: rows @ x - values, start, jac=lambda x: rows, x_scale="jac", loss="huber", f_scale=scale).x
    weights: Array = np.minimum(1.0, scale / np.maximum(np.abs(values - rows @ answer), 1e-300))
    return weights


class Blocks:
    """Weighted linear least squares over blocks of equations: the solution of all, and those without each block.

    rows: (n, k) coefficients, values: (n,), block: (n,) numbers from 0, weights: (n,) or None for 1.
    """

    def __init__(self, rows: Array, values: Array, block: Any, weights: Optional[Array] = None) -> None:
        whole = np.column_stack([rows, values])
        weighted = whole if weights is None else whole * weights[:, None]
        number = np.asarray(block)
        #: The normal equations of each block, with `values` as the last column: shape (blocks, k + 1, k + 1).
        self.products = np.array([whole[number == one].T @ weighted[number == one] for one in range(int(number.max()) + 1)])

    def __len__(self) -> int:
        return len(self.products)

    def solve(self, fixed: dict[int, float]) -> "Optional[tuple[Array, Array]]":
        """The solution of all equations, shape (k,), and those without each block, shape (blocks, k).

        fixed: given values of unknowns, by their index. None if the equations do not determine the others.
        """
        total = self.products.sum(axis=0)
        answers = [_solution(products, fixed) for products in [total, *(total - self.products)]]
        if any(answer is None for answer in answers):
            return None
        return answers[0], np.array(answers[1:])  # type: ignore[return-value]

    def squares(self, answers: Array) -> Array:
        """The weighted sum of squared residuals of each block under its own solution answers[i], shape (blocks,)."""
        with_value = np.column_stack([-answers, np.ones(len(answers))])
        squares: Array = np.maximum(0.0, np.einsum("bi,bij,bj->b", with_value, self.products, with_value))
        return squares


def _solution(products: Array, fixed: dict[int, float]) -> Optional[Array]:
    size = len(products) - 1
    free = [i for i in range(size) if i not in fixed]
    answer = np.zeros(size)
    answer[list(fixed)] = list(fixed.values())
    units = np.diag(products)[free]
    if not (units > 0.0).all():
        return None
    units = 1.0 / np.sqrt(units)
    matrix = products[np.ix_(free, free)] * np.outer(units, units)
    right = (products[free, -1] - products[free, :-1] @ answer) * units
    try:
        pivots = np.diag(np.linalg.cholesky(matrix)) ** 2
    except np.linalg.LinAlgError:
        return None
    if not (pivots > 1e-10).all():
        return None
    answer[free] = units * np.linalg.solve(matrix, right)
    return answer
