"""Estimates the travel per encoder count from known distances."""

from dataclasses import dataclass

import numpy as np

from ._estimates import Array, Blocks, Estimate, jackknife, robust_weights, within
from ._logs import Log


@dataclass
class CountFit:
    """The result of fit_count."""

    count: Estimate = Estimate()  #: mm of travel per count, mean of both wheels
    way: float = 0.0  #: known distance in mm
    missed: float = 0.0  #: rms error in mm at places left out of the fit; 0 if only the whole distance is known
    refusal: str = ""  #: why there is no fit


def fit_count(log: Log, way: float = 0.0, way_error: float = 1.0) -> CountFit:
    """Fits the travel per count.

    way, way_error: measured distance in mm from the first to the last row, and its standard error. With a `way` of 0,
    the log's column `way` is used.
    Method: a straight line of position over counts, by least squares with Huber's loss. The error is the larger one of
    two jackknives: over blocks of positions, and over differences between positions, which covers cumulative errors.
    """
    if "left_count" not in log:
        return CountFit(refusal="the log has no counts")
    counts = (log["left_count"] + log["right_count"]) / 2.0
    if way > 0.0:
        fit = CountFit(way=way)
        driven = abs(counts[-1] - counts[0])
        if driven >= 10.0:
            fit.count = Estimate(way / driven, way / driven * max(way_error / way, 1.0 / driven))
        else:
            fit.refusal = "the encoders hardly count on that way"
        return fit
    if "way" not in log:
        return CountFit(refusal="the log has no known way")
    known = ~np.isnan(log["way"])
    return _fit_places(counts[known], log["way"][known])


def _fit_places(counts: Array, ways: Array) -> CountFit:
    places = len(ways)
    if places < 6:
        return CountFit(refusal=f"the way is known in {places} rows, and must be in 6")
    fit = CountFit(way=float(ways.max() - ways.min()))
    number = min(20, places - 1)
    points = np.column_stack([counts - counts.mean(), np.ones(places)])
    values = ways - ways.mean()
    weights = robust_weights(points, values, 0.0)
    line = Blocks(points, values, np.arange(places) * number // places, weights)
    ends = np.arange(number + 1) * (places - 1) // number
    steps = Blocks(np.diff(counts[ends])[:, None], np.diff(ways[ends]), np.arange(number))
    solved, summed = line.solve({}), steps.solve({})
    if solved is None or summed is None or solved[0][0] <= 0.0:
        fit.refusal = "the way that is known does not grow with the counts: are these the right columns?"
        return fit
    fit.missed = float(np.sqrt(line.squares(solved[1]).sum() / places))
    slope = solved[0][0]
    error = max(jackknife(solved[1])[0], jackknife(summed[1])[0])
    fit.count = within(slope, error, 0.1 * slope, "counts and the way that is known do not go together", number - 1.0)
    return fit
