#!/usr/bin/env python3
"""Measures the speed of the Python package: prints the tables of docs/research/timings.md, "Python".

usage: PYTHONPATH=build/release/python build/python-tools/bin/python bench/python.py

Times are processor times, the best or the median of several runs. Those of Ctrl-C are wall-clock times.
"""

import statistics
import subprocess
import sys
import tempfile
import time

import labmouse

INTERRUPTED = """
import os, signal, sys, threading, time
import labmouse
from labmouse import learn
from labmouse.learn.train import train
def interrupt():
    time.sleep({after})
    sent.append(time.monotonic())
    os.kill(os.getpid(), signal.SIGINT)
class Still:
    def decide(self, seen):
        return 0, 0
class Lost:  # never answers
    def decide(self, seen):
        while True: pass
class Asleep:  # nor does this one, in compiled code
    def decide(self, seen):
        time.sleep(1000)
guest = "program:" + sys.executable + ' -c "import time; time.sleep(1000)"'  # nor does that
envs = learn.ContestVectorEnv(20_000, "train")
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell has it ignored in what runs in its background
sent = []
threading.Thread(target=interrupt, daemon=True).start()
try:
    {long}
except KeyboardInterrupt:
    pass
print(time.monotonic() - sent[0])
"""
RACE = "labmouse.race([{mice}], runs=2000, budget=1_000_000, jobs={jobs}, progress=False)"
#: Long calls of each kind, which are interrupted.
LONG = {
    "a race of built-in mice": RACE.format(mice="'random'", jobs=0),
    "the same with a store": RACE.format(mice="'random'", jobs=0)[:-1] + ", store=sys.argv[1] + '/results.db')",
    "the same in seconds": "labmouse.race('ariadne,ariadne-deep,certify', learn.MazeSet('test', size=32)[:400], world='seconds', robot='kerise', progress=False)",
    "a mouse in Python": RACE.format(mice="Still", jobs=2),
    "one that never answers": RACE.format(mice="Lost", jobs=2),
    "one that sleeps in compiled code": RACE.format(mice="Asleep", jobs=2),
    "a guest that never answers": RACE.format(mice="guest", jobs=2),
    "a study of mice that learn": "labmouse.study('ariadne,ariadne-deep', learn.MazeSet('test', size=32)[:100], folds=5, progress=False)",
    "bounds": "while True: labmouse.bound(learn.MazeSet('test', size=32)[1], world='seconds', robot='kerise')",
    "routes": "while True: labmouse.route(learn.MazeSet('test', size=32)[1], robot='kerise')",
    "an environment that makes its mazes": "envs.reset(seed=1)",
    "a training": "train(seconds=600, generations=10**6, jobs=2, seed=1, size=16, budget=400)",
}


class Still:
    """The fastest possible mouse."""

    def decide(self, seen: labmouse.Sighting) -> labmouse.Action:
        return 0, 0


def seconds_of_import() -> float:
    """Median processor time of `import labmouse` in s, without the start of the interpreter."""
    code = "import time; begin = time.process_time(); import labmouse; print(time.process_time() - begin)"
    times = [float(subprocess.run([sys.executable, "-c", code], capture_output=True, check=True).stdout) for _ in range(9)]
    return statistics.median(times)


def decisions_a_second() -> float:
    """Decisions per second of processor time, in a contest of 100,000 steps; the best of five."""
    best = 0.0
    for _ in range(5):
        begin = time.process_time()
        labmouse.run(Still, "contest-01", budget=100_000, debug=True, progress=False)
        best = max(best, 1e5 / (time.process_time() - begin))
    return best


def seconds_to_stop(long: str, busy: int) -> list[float]:
    """Five wall-clock times in s from SIGINT to the end of the call `long`, beside `busy` processes at full load."""
    others = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(busy)]
    times = []
    try:
        for number in range(5):
            with tempfile.TemporaryDirectory() as folder:
                code = INTERRUPTED.format(long=long, after=1.5 + 0.13 * number)
                ran = subprocess.run([sys.executable, "-c", code, folder], capture_output=True, text=True, check=True)
            times.append(float(ran.stdout.splitlines()[-1]))
    finally:
        for other in others:
            other.kill()
            other.wait()
    return times


def main() -> None:
    print(f"| importing labmouse | {seconds_of_import():.3f} s |")
    print("| decisions of a mouse in Python that always answers the same, with `debug=True` | "
          f"{decisions_a_second() / 1e3:.0f} thousand a second |")
    print("\n| milliseconds from Ctrl-C to what is done: median and slowest of 5 | alone | beside two busy programs |")
    for name, long in LONG.items():
        cells = [f"{1000 * statistics.median(times):.0f}, {1000 * max(times):.0f}" for times in (seconds_to_stop(long, 0), seconds_to_stop(long, 2))]
        print(f"| {name} | {cells[0]} | {cells[1]} |", flush=True)


if __name__ == "__main__":
    main()
