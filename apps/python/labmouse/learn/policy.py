"""A linear policy for exploration: a move is scored by a weighted sum of its features.

In the search run the policy makes the move with the largest sum, among those that are known to be free of walls. The
features are local: what is known of the cell in which the move ends, of the passages on the way there, where the mouse
was before, and the direction of the goal. There is no search and no distance field. After it has entered the goal, the
mouse uses a second set of weights, with the start as its goal, until it is in the start or more than `patience` steps
have passed. Then it resets. Only the speed run is planned: a shortest route through known passages.

All arrays hold n contests: the first axis is the contest. Cells have the index y * width + x.
"""

from typing import Any, Tuple

import numpy as np
from numpy.typing import NDArray

from .spaces import RESET

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

#: The features of a move.
FEATURES = (
    "unseen sides in view",  # of the three sides in view at the end of the move, the share that is unknown
    "visited",  # whether the mouse has been in the cell where the move ends
    "visits",  # log(1 + steps that ended there)
    "first marks",  # log(1 + number of times the mouse used the first passage of the move)
    "last marks",  # the same for the last passage
    "nearer to the goal",  # by how many cells the move reduces the Manhattan distance, divided by 3
    "cells",  # length of the move in cells, divided by 3
    "turns back",  # whether it goes against the direction of the last move
    "to its parent",  # whether its first passage is the one by which the mouse first came to this cell
    "ways on",  # open passages from the last cell to unvisited cells, divided by 3
    "ways passed",  # the same from the cells that the move passes through
    "dead end",  # whether three sides of the last cell are known to be closed
    "in the goal",  # whether the move ends in the goal; passing through does not count
    "stays",  # whether it only turns
)
WEIGHTS = 2 * len(FEATURES) + 1

# The 21 steps by their numbers: quarter turns, direction in quarter turns from the heading, cells.
_number = np.arange(RESET)
_TURN = _number // 7 - 1
_CELLS = np.abs(_number % 7 - 3)
_DIRECTION = np.where(_number % 7 < 3, _TURN + 2, _TURN) % 4
_DX, _DY = np.array([0, 1, 0, -1]), np.array([1, 0, -1, 0])


class Policy:
    """The policy in n contests in mazes of one size; each contest may have its own weights.

    Args:
        weights: shape (n, WEIGHTS) or (WEIGHTS,): weights before the goal, weights after it, and a value v for the
            patience of 20 * exp(v) steps.
        count: n.
        size: (width, height) in cells.
    """

    def __init__(self, weights: Floats, count: int, size: Tuple[int, int]) -> None:
        self.width, self.height = size
        weights = np.broadcast_to(weights, (count, WEIGHTS))
        k = len(FEATURES)
        self.weights = np.stack([weights[:, :k], weights[:, k : 2 * k]], axis=1)
        self.patience = 20.0 * np.exp(np.clip(weights[:, -1], -8.0, 4.0))
        area = self.width * self.height
        self.visits = np.zeros((count, area))
        self.marks = np.zeros((count, area, 4))
        self.parent = np.full((count, area), -1, np.int8)
        self.last = np.full(count, -1, np.int64)  # direction of the last move
        self.since_goal = np.zeros(count)
        self.field = np.full((count, area), -1, np.int16)  # of the speed run: steps to the goal
        self.planned = np.zeros(count, np.bool_)

    def decide(self, bits: NDArray[np.uint16], sightings: NDArray[np.int16], which: Ints) -> Ints:
        """The actions in the contests with the indices `which`. bits, sightings: their observations, in that order."""
        rows: Ints = sightings.astype(np.int64)
        bits = bits.reshape(len(which), -1)
        x, y, heading = rows[:, 3], rows[:, 4], rows[:, 5]
        place = y * self.width + x
        at_goal = rows[:, 7] > 0
        running = rows[:, 6] > 0
        self.since_goal[which] += at_goal
        home = place == self._start[which]
        resets = at_goal & ~running & ((self.since_goal[which] > self.patience[which]) | home)
        actions = np.full(len(which), RESET, np.int64)
        plans = (resets | running) & ~self.planned[which]
        if plans.any():
            self._plan(bits[plans], which[plans])
        explores = ~resets & ~running
        if explores.any():
            now = np.flatnonzero(explores)
            actions[now] = self._explore(bits[now], rows[now], place[now], which[now])
        if running.any():
            now = np.flatnonzero(running)
            actions[now] = self._run(bits[now], x[now], y[now], heading[now], which[now])
        return actions

    def begin(self, sightings: NDArray[np.int16]) -> None:
        """Begins all contests, from their first sightings."""
        rows: Ints = sightings.astype(np.int64)
        self._start = rows[:, 4] * self.width + rows[:, 3]
        self._start_x, self._start_y = rows[:, 3].copy(), rows[:, 4].copy()
        self.visits[np.arange(len(rows)), self._start] = 1

    def _straights(self, bits: NDArray[np.uint16], x: Ints, y: Ints) -> Tuple[NDArray[np.bool_], Ints]:
        """Whether k cells in a direction are known free, and the cell there; shapes (n, direction, k = 0 to 3)."""
        n = len(x)
        k = np.arange(4)
        xs = x[:, None, None] + _DX[None, :, None] * k
        ys = y[:, None, None] + _DY[None, :, None] * k
        inside = (xs >= 0) & (xs < self.width) & (ys >= 0) & (ys < self.height)
        places = np.where(inside, ys * self.width + xs, 0)
        word = np.take_along_axis(bits, places.reshape(n, 16), axis=1).reshape(n, 4, 4)
        way_on = word >> np.arange(4, dtype=np.uint16)[None, :, None] & 1 > 0
        free = np.ones((n, 4, 4), np.bool_)
        free[:, :, 1:] = np.logical_and.accumulate(way_on[:, :, :3], axis=2)
        return free, places

    def _explore(self, bits: NDArray[np.uint16], rows: Ints, place: Ints, which: Ints) -> Ints:
        n = len(which)
        x, y, heading = rows[:, 3], rows[:, 4], rows[:, 5]
        free, places = self._straights(bits, x, y)
        flat = places.reshape(n, 16)
        word = np.take_along_axis(bits, flat, axis=1).reshape(n, 4, 4)
        contest = which[:, None]
        visits = self.visits[contest, flat].reshape(n, 4, 4)
        visited = word >> 8 & 1 > 0
        goal = word >> 13 & 1 > 0
        after = rows[:, 7]
        target_x = np.where(after > 0, self._start_x[which], (rows[:, 12] + rows[:, 14]) / 2)
        target_y = np.where(after > 0, self._start_y[which], (rows[:, 13] + rows[:, 15]) / 2)
        px, py = places % self.width, places // self.width
        far = np.abs(px - target_x[:, None, None]) + np.abs(py - target_y[:, None, None])
        marks = np.log1p(self.marks[contest, flat].reshape(n, 4, 4, 4))
        side = np.arange(4)
        # By side of each cell: whether it is an open passage to an unvisited cell.
        beyond = self._unvisited_ways(bits, px, py, word)
        ways = beyond.sum(axis=3)
        passed = np.cumsum(ways, axis=2) - ways
        passed[:, :, 1:] -= ways[:, :, :1]  # the mouse's own cell does not count
        closed = word >> 4 & 15
        dead = np.isin(closed, (7, 11, 13, 14))
        seen = (word | word >> 4) & 15
        back = (side[None, :] == (self.last[which] + 2)[:, None] % 4) & (self.last[which] >= 0)[:, None]
        to_parent = side[None, :] == self.parent[which, place][:, None]

        direction = (heading[:, None] + _DIRECTION) % 4  # (n, 21)
        facing = (heading[:, None] + _TURN) % 4
        cells = np.broadcast_to(_CELLS, (n, RESET))
        i = np.arange(n)[:, None]
        end = (i, direction, cells)
        sides = (facing[:, :, None] + np.array([-1, 0, 1])) % 4
        unseen = 3 - (seen[end][:, :, None] >> sides & 1).sum(axis=2)
        moves = cells > 0
        first = marks[i, direction, 0, direction]
        last = marks[i, direction, np.maximum(cells - 1, 0), direction]
        features = np.stack(
            [
                unseen / 3, visited[end], np.log1p(visits[end]), first * moves, last * moves,
                (far[:, :1, 0] - far[end]) / 3, cells / 3, back[i, direction] & moves,
                to_parent[i, direction] & moves, ways[end] / 3, passed[end] / 3, dead[end],
                goal[end], ~moves,
            ],
            axis=2,
        )  # fmt: skip
        values = (features * self.weights[which, after][:, None, :]).sum(axis=2)
        still = ~moves & (_TURN == 0)
        chosen: Ints = np.where(free[end] & ~still, values, -np.inf).argmax(axis=1)
        return chosen

    def _unvisited_ways(self, bits: NDArray[np.uint16], px: Ints, py: Ints, word: NDArray[Any]) -> NDArray[np.bool_]:
        """Whether a side of a cell is known to be open and leads to an unvisited cell, shape (n, 4, 4, 4 sides)."""
        n = len(bits)
        xs, ys = px[..., None] + _DX, py[..., None] + _DY
        inside = (xs >= 0) & (xs < self.width) & (ys >= 0) & (ys < self.height)
        places = np.where(inside, ys * self.width + xs, 0)
        visited = np.take_along_axis(bits, places.reshape(n, 64), axis=1).reshape(n, 4, 4, 4) >> 8 & 1
        is_open = word[..., None] >> np.arange(4, dtype=np.uint16) & 1
        ways: NDArray[np.bool_] = (is_open > 0) & (visited == 0) & inside
        return ways

    def moved(self, sightings: NDArray[np.int16], later: NDArray[np.int16], which: Ints) -> None:
        """Updates visits and marks, from the sightings of the contests `which` before and after a step."""
        before: Ints = sightings.astype(np.int64)
        after: Ints = later.astype(np.int64)
        explored = after[:, 6] == 0
        before, after, which = before[explored], after[explored], which[explored]
        dx, dy = after[:, 3] - before[:, 3], after[:, 4] - before[:, 4]
        cells = np.abs(dx) + np.abs(dy)
        direction = np.select([dy > 0, dx > 0, dy < 0], [0, 1, 2], 3)
        self.visits[which, after[:, 4] * self.width + after[:, 3]] += 1
        self.last[which] = np.where(cells > 0, direction, self.last[which])
        for k in range(3):
            now = np.flatnonzero(cells > k)
            if not len(now):
                break
            d, w = direction[now], which[now]
            here = (before[now, 4] + _DY[d] * k) * self.width + before[now, 3] + _DX[d] * k
            there = here + _DY[d] * self.width + _DX[d]
            back = (d + 2) % 4
            self.marks[w, here, d] += 1
            self.marks[w, there, back] += 1
            new = (self.parent[w, there] < 0) & (there != self._start[w])
            self.parent[w[new], there[new]] = back[new]

    def _plan(self, bits: NDArray[np.uint16], which: Ints) -> None:
        """Computes the steps to the goal from each cell through known passages, for the speed run."""
        grid = bits.reshape(len(which), self.height, self.width)
        is_open = [grid >> d & 1 > 0 for d in range(4)]
        field = np.full(grid.shape, -1, np.int16)
        reached = grid >> 13 & 1 > 0
        field[reached] = 0
        layer = reached
        steps = 0
        while layer.any():
            steps += 1
            spread = np.zeros_like(layer)
            for d in range(4):
                front = layer
                for _ in range(3):
                    # A cell from which the passage in direction d leads into the front.
                    came = np.zeros_like(front)
                    if d == 0:
                        came[:, :-1] = front[:, 1:]
                    elif d == 1:
                        came[:, :, :-1] = front[:, :, 1:]
                    elif d == 2:
                        came[:, 1:] = front[:, :-1]
                    else:
                        came[:, :, 1:] = front[:, :, :-1]
                    front = came & is_open[d]
                    spread |= front
            layer = spread & ~reached
            reached = reached | layer
            field[layer] = steps
        self.field[which] = field.reshape(len(which), -1)
        self.planned[which] = True

    def _run(self, bits: NDArray[np.uint16], x: Ints, y: Ints, heading: Ints, which: Ints) -> Ints:
        n = len(which)
        free, places = self._straights(bits, x, y)
        steps = self.field[which[:, None], places.reshape(n, 16)].reshape(n, 4, 4)
        direction = (heading[:, None] + _DIRECTION) % 4
        i = np.arange(n)[:, None]
        left = steps[i, direction, _CELLS]
        good = free[i, direction, _CELLS] & (left >= 0) & (_CELLS > 0)
        chosen: Ints = np.where(good, left, np.int16(32767)).argmin(axis=1)
        return chosen
