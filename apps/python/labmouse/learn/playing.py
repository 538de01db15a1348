"""Plays contests with a policy, through the vector environment."""

from typing import Sequence

import numpy as np

from .. import Maze
from .policy import Floats, Policy
from .vector import ContestVectorEnv


def play(weights: Floats, mazes: Sequence[Maze], budget: int = 1000, seen_pays: bool = False) -> Floats:
    """Runs each policy in each maze once. Returns the returns (minus the scores), shape (policies, mazes).

    Args:
        weights: shape (policies, WEIGHTS).
        mazes: mazes of one size.
        budget: number of steps of a contest.
        seen_pays: whether a failed contest returns -100 - 100 * (share of cells that were not visited), not -100.
    """
    policies, count = len(weights), len(weights) * len(mazes)
    envs = ContestVectorEnv(count, mazes=list(mazes), observation="bits", order="in turn", budget=budget)
    bits, _ = envs.reset(seed=0)
    width, height = int(envs.sightings[0, 10]), int(envs.sightings[0, 11])
    policy = Policy(np.repeat(weights, len(mazes), axis=0), count, (width, height))
    policy.begin(envs.sightings)
    returns = np.zeros(count)
    actions = np.zeros(count, np.int64)
    which = np.arange(count)
    while len(which):
        before = envs.sightings[which]
        actions[which] = policy.decide(bits[which], before, which)
        bits, _, ended, _, info = envs.step(actions)
        over = ended[which]
        returns[which[over]] = info["return"][which[over]]
        if seen_pays and over.any():
            failed = which[over & (info["state"][which] != 1)]
            visited = (bits[failed] >> 8 & 1).mean(axis=(1, 2))
            returns[failed] -= 100 * (1 - visited)
        policy.moved(before, envs.sightings[which], which)
        which = which[~over]
    return returns.reshape(policies, len(mazes))
