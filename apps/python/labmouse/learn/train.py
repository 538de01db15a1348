"""Trains the policy of labmouse.learn.policy by an evolution strategy: python -m labmouse.learn.train --out mouse.json

Each generation draws antithetic pairs of weights around the present ones. All play the same new mazes of the set
'train', and the present weights follow the gradient estimated from the ranks of the returns (Salimans et al. 2017,
arXiv:1703.03864, with Adam). Every fifth generation, the present weights play mazes of the set 'validation'; the best
ones are saved. The weights start at 0, which prefers no move. In training, a failed contest costs less, the more cells
the mouse visited: otherwise all policies of the first generations would have equal returns.
"""

import argparse
import json
import os
import signal
import threading
import time
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager, nullcontext
from typing import Any, Callable, Dict, Iterator, List, Optional

import numpy as np

from .. import Maze
from .._native import write_file
from .mazes import MazeSet
from .playing import play
from .policy import FEATURES, WEIGHTS, Floats

MAZES, PAIRS, SPREAD, RATE = 16, 12, 0.3, 0.2


def _play(weights: Floats, mazes: List[Maze], budget: int) -> Floats:
    return play(weights, mazes, budget, seen_pays=True)


def _parts(weights: Floats, mazes: List[Maze], budget: int, pool: Optional[ProcessPoolExecutor], jobs: int) -> Floats:
    if pool is None:
        return _play(weights, mazes, budget)
    parts = [part for part in np.array_split(weights, jobs) if len(part)]
    return np.concatenate(list(pool.map(_play, parts, [mazes] * len(parts), [budget] * len(parts))))


def ranks(returns: Floats) -> Floats:
    """The ranks of returns, scaled to -0.5 (worst) to 0.5 (best); equal returns have equal ranks."""
    above = np.greater.outer(returns, returns).sum(axis=1) - np.less.outer(returns, returns).sum(axis=1)
    return np.asarray(above / (2 * len(returns) - 2), np.float64)


@contextmanager
def _ctrl_c() -> Iterator[Callable[[], bool]]:
    """A context in which Ctrl-C only sets a flag; yields a function that returns the flag. Reason: a KeyboardInterrupt
    during the start of a process would leave that process running."""
    pressed: List[int] = []
    before = signal.getsignal(signal.SIGINT)
    hears = before not in (signal.SIG_IGN, None) and threading.current_thread() is threading.main_thread()
    if hears:
        signal.signal(signal.SIGINT, lambda number, _: pressed.append(number))
    try:
        yield lambda: bool(pressed)
    finally:
        if hears:
            signal.signal(signal.SIGINT, before)


def train(seconds: float, generations: int, jobs: int, seed: int, size: int, budget: int, kind: str = "contest") -> Dict[str, Any]:
    """Trains until `seconds`, `generations` or Ctrl-C end it. Returns the content of the file for the best policy."""
    rng = np.random.default_rng(seed)
    mazes, validation = MazeSet("train", kind=kind, size=size), MazeSet("validation", kind=kind, size=size)[:100]
    mean, momentum, square = np.zeros(WEIGHTS), np.zeros(WEIGHTS), np.zeros(WEIGHTS)
    best, best_score = mean, np.inf
    curve: List[Dict[str, float]] = []
    begin, processor, generation = time.monotonic(), os.times(), 0
    with _ctrl_c() as interrupted, ProcessPoolExecutor(jobs) if jobs > 1 else nullcontext() as pool:
        while True:
            over = generation == generations or time.monotonic() - begin > seconds or interrupted()
            if generation % 5 == 0 or over:
                score = -float(play(mean[None], validation).mean())
                curve.append({"generation": generation, "seconds": time.monotonic() - begin, "validation": score})
                print(f"generation {generation:4d}  {time.monotonic() - begin:6.1f} s  validation {score:.2f}", flush=True)
                if score < best_score:
                    best, best_score = mean.copy(), score
            if over:
                break
            first = generation * MAZES
            noise = rng.standard_normal((PAIRS, WEIGHTS))
            tried = mean + SPREAD * np.concatenate([noise, -noise])
            returns = _parts(tried, mazes[first : first + MAZES], budget, pool, jobs).mean(axis=1)
            rank = ranks(returns)
            slope = (rank[:PAIRS] - rank[PAIRS:]) @ noise / (2 * PAIRS * SPREAD)
            generation += 1
            momentum = 0.9 * momentum + 0.1 * slope
            square = 0.99 * square + 0.01 * slope**2
            mean = mean + RATE * (momentum / (1 - 0.9**generation)) / (np.sqrt(square / (1 - 0.99**generation)) + 1e-8)
        if interrupted():
            print("interrupted", flush=True)
    now = os.times()
    used = sum(now[:4]) - sum(processor[:4])
    return {
        "mouse": "labmouse.learn.policy", "features": list(FEATURES), "weights": [round(float(w), 4) for w in best],
        "trained": {"size": size, "seed": seed, "generations": generation, "seconds": round(time.monotonic() - begin, 1),
                    "processor_seconds": round(used, 1), "validation": round(best_score, 3)},
        "curve": [{name: round(value, 2) for name, value in point.items()} for point in curve],
    }  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m labmouse.learn.train", description="Trains a mouse that learns to explore.")
    parser.add_argument("--out", required=True, help="the file to write, JSON")
    parser.add_argument("--seconds", type=float, default=600.0, help="time limit (default 600)")
    parser.add_argument("--generations", type=int, default=100, help="at most so many (default 100)")
    parser.add_argument("--jobs", type=int, default=2, help="processes (default 2)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--size", type=int, default=16, help="side of the mazes (default 16)")
    parser.add_argument("--kind", default="contest", help="their generator (default contest)")
    parser.add_argument("--budget", type=int, default=400, help="steps of a contest in training (default 400)")
    options = parser.parse_args()
    out = options.__dict__.pop("out")
    result = train(**options.__dict__)
    write_file(out, json.dumps(result, indent=1) + "\n")


if __name__ == "__main__":
    main()
