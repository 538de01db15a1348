"""Compares the speed of maze environments on one core: labmouse.learn, MiniGrid and mazemdp.

    python3 -m venv build/bench-learning
    build/bench-learning/bin/pip install --require-hashes -r bench/learning/requirements.txt
    build/bench-learning/bin/pip install --no-deps build/dist/labmouse-*.whl
    build/bench-learning/bin/python bench/learning/speed.py

Measures steps per second of processor time with random actions, the best of three rounds, including the time to draw
the actions.
"""

import argparse
import platform
import time
from typing import Any, Callable, Dict, Tuple

import gymnasium
import numpy as np
from gymnasium.vector import SyncVectorEnv

import labmouse
from labmouse import learn


def best(steps: int, play: Callable[[], None], rounds: int) -> float:
    times = []
    for _ in range(rounds):
        begin = time.process_time()
        play()
        times.append(time.process_time() - begin)
    return steps / min(times)


def ours(observation: str, mazes: Any, rounds: int, batch: int = 4096, steps: int = 400) -> Tuple[float, int]:
    envs = learn.ContestVectorEnv(batch, mazes, observation)
    envs.reset(seed=1)
    actions = np.empty(batch, np.int64)

    def play() -> None:
        for _ in range(steps):
            envs.step(envs.draw_valid_actions(actions))

    play()  # now the contests are at different steps
    return best(steps * batch, play, rounds), envs.nbytes_per_env


def single(rounds: int, steps: int = 5_000) -> float:
    env = learn.ContestEnv("train")
    _, info = env.reset(seed=1)

    def play() -> None:
        nonlocal info
        for _ in range(steps):
            action = env.action_space.sample(mask=info["action_mask"])
            _, _, ended, _, info = env.step(action)
            if ended:
                _, info = env.reset()

    return best(steps, play, rounds)


def minigrid(name: str, rounds: int, batch: int = 16, steps: int = 60) -> float:
    import minigrid  # noqa: F401

    envs = SyncVectorEnv([lambda: gymnasium.make(name, disable_env_checker=True) for _ in range(batch)])
    envs.reset(seed=1)

    def play() -> None:
        for _ in range(steps):
            envs.step(envs.action_space.sample())

    return best(batch * steps, play, rounds)


def mazemdp(rounds: int, steps: int = 2_000) -> float:
    from mazemdp import create_random_maze

    mdp = create_random_maze(10, 10, hit=True, ratio=0.2, start_states=[0])
    mdp = mdp[0] if isinstance(mdp, tuple) else mdp
    mdp.reset()
    rng = np.random.default_rng(1)

    def play() -> None:
        for action in rng.integers(mdp.nb_actions, size=steps):
            if mdp.step(int(action))[2]:
                mdp.reset()

    return best(steps, play, rounds)


def show(name: str, speed: float, note: str) -> None:
    print(f"{name:46s} {speed:14,.0f} steps/s  {note}", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description="Measures environments for mazes beside each other.")
    parser.add_argument("--rounds", type=int, default=3)
    rounds = parser.parse_args().rounds
    print(f"labmouse {labmouse.__version__}, Python {platform.python_version()}, numpy {np.__version__}, gymnasium {gymnasium.__version__}")
    mazes = learn.MazeSet("train", count=1000)[:]
    said: Dict[str, str] = {"sighting": "16 numbers", "bits": "16x16 words of 16 bits", "belief": "16x16x16 bytes of 0 or 1"}
    for observation, what in said.items():
        speed, size = ours(observation, mazes, rounds)
        show(f"labmouse.learn, 4096 at once, {observation}", speed, f"{what}; {size} bytes an environment")
    show("512 at once, sighting, a new maze each contest", ours("sighting", "train", 1, 512, 1100)[0], "16x16, made by the generator")
    show("labmouse.learn, one environment, sighting", single(rounds), "actions drawn by Gymnasium")
    show("MiniGrid-MultiRoom-N6-v0, 16 at once", minigrid("MiniGrid-MultiRoom-N6-v0", rounds), "7x7x3 bytes of view, 25x25 cells")
    show("MiniGrid-Empty-16x16-v0, 16 at once", minigrid("MiniGrid-Empty-16x16-v0", rounds), "7x7x3 bytes of view")
    show("mazemdp, 10x10, one", mazemdp(rounds), "the cell's number, no Gymnasium environment")

if __name__ == "__main__":
    main()
