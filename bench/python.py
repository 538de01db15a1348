#!/usr/bin/env python3
"""How fast the Python package is: prints the table of docs/python.md.

usage: PYTHONPATH=build/release/python build/python-tools/bin/python bench/python.py

Times are those of the processor, the best of several, but for Ctrl-C, whose time is by the clock.
"""

import statistics
import subprocess
import sys
import time

import labmouse

INTERRUPTED = """
import os, signal, sys, threading, time
import labmouse
def interrupt():
    time.sleep(1.5)
    sent.append(time.monotonic())
    os.kill(os.getpid(), signal.SIGINT)
class Still:
    def decide(self, seen):
        return 0, 0
class Lost:  # never answers
    def decide(self, seen):
        while True: pass
guest = "guest:" + sys.executable + ' -c "import time; time.sleep(1000)"'  # nor does that
sent = []
threading.Thread(target=interrupt).start()
race = labmouse.race([{mice}], runs=2000, budget=1000000, jobs={jobs}, progress=False)
print(time.monotonic() - sent[0])
assert not race.complete
"""


class Still:
    """Decides as little as a mouse can."""

    def decide(self, seen: labmouse.Sighting) -> labmouse.Action:
        return 0, 0


def seconds_of_import() -> float:
    """Of the package alone, without the interpreter's own start."""
    code = "import time; begin = time.process_time(); import labmouse; print(time.process_time() - begin)"
    times = [float(subprocess.run([sys.executable, "-c", code], capture_output=True, check=True).stdout) for _ in range(9)]
    return statistics.median(times)


def decisions_a_second() -> float:
    """In one contest of a million steps."""
    best = 0.0
    for _ in range(5):
        begin = time.process_time()
        labmouse.race(Still, "contest-01", budget=1_000_000, jobs=1, progress=False)
        best = max(best, 1e6 / (time.process_time() - begin))
    return best


def seconds_to_stop(mice: str, jobs: int) -> float:
    """From the signal to the end of the race, by the clock."""
    code = INTERRUPTED.format(mice=mice, jobs=jobs)
    times = [float(subprocess.run([sys.executable, "-c", code], capture_output=True, check=True).stdout) for _ in range(5)]
    return statistics.median(times)


def main() -> None:
    print(f"| importing labmouse | {seconds_of_import():.3f} s |")
    print(f"| decisions of a mouse in Python that always answers the same | {decisions_a_second() / 1e6:.1f} million a second |")
    stops = {(mice, jobs): seconds_to_stop(mice, jobs) for mice, jobs in (
        ("'random'", 0), ("Still, 'random'", 1), ("Still", 2), ("Lost", 1), ("Lost", 2), ("guest", 2))}
    print(f"| from Ctrl-C to what is done, the slowest of {len(stops)} kinds of races | {max(stops.values()):.2f} s |")


if __name__ == "__main__":
    main()
