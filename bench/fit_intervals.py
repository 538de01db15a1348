#!/usr/bin/env python3
"""Measures how often the 95 % intervals of labmouse.fit contain the true number, on logs of the physical world.

usage: PATH=build/release:$PATH PYTHONPATH=build/release/python build/python-tools/bin/python bench/fit_intervals.py
           [--cases N] [--first N] [--rates HZ,HZ...] [--jobs N]

A case is one drive of the fastest route of a built-in maze. Its robot is kerise, classic or beginner with motors drawn at
random: gains vary by 15 % and time constants by 20 % (standard deviations), dead zones are 0 to 8 %. The fit gets the log with
the rows of a slower logger, and the unchanged robot as its base. Noise is as measured. Prints, by rate and number, the share of
cases in which the interval contains the true number. Exits with 1 if one of them is outside 90 to 99 %, by more than the error
of a share: two standard deviations of a binomial distribution.
"""

import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
from multiprocessing import Pool
from pathlib import Path

import numpy as np
from labmouse import _native, fit

ROBOTS = ("kerise", "classic", "beginner")
COLUMNS = "time,left,right,left_count,right_count,gyro*{},volts=millivolts/1000"
NUMBERS = tuple(f"motors.{axis}_{number}" for axis in ("drive", "turn") for number in ("gain", "time", "dead_zone"))
LOW, HIGH = 0.90, 0.99


def drawn_robot(number):
    """The base robot of a case, and its parameters with the motors of that case."""
    random = np.random.default_rng([7, number])
    base = fit.base_numbers(ROBOTS[number % len(ROBOTS)])
    true = dict(base)
    for axis in ("drive", "turn"):
        true[f"motors.{axis}_gain"] *= math.exp(random.normal(0.0, 0.15))
        true[f"motors.{axis}_time"] *= math.exp(random.normal(0.0, 0.2))
        true[f"motors.{axis}_dead_zone"] = random.uniform(0.0, 0.08)
    # All that differs besides is the scale of each wheel.
    for key in true:
        if key.startswith("variation.") and key != "variation.encoder_scale":
            true[key] = 0.0
    return base, true


def driven(number, folder):
    """The log of a case with a row for each ms, its base robot, and the true parameters."""
    base, true = drawn_robot(number)
    robot, path = Path(folder) / f"{number}.toml", Path(folder) / f"{number}.csv"
    robot.write_text(_native.robot_file(json.dumps(true), {}, "drawn")[0], encoding="utf-8")
    words = f"drive --fast --mazes contest-{1 + number % 10:02d} --runs 1 --seed {number + 1} --variation contest".split()
    subprocess.run(["labmouse", *words, "--robot", str(robot), "--log", str(path)], check=True, capture_output=True)
    return fit.read_log(path, COLUMNS.format(base["sensors.gyro_step"])), base, true


def slower(log, rate):
    """The log with the rows of a logger of this rate in Hz."""
    step = round(1000 / rate)
    return fit.Log(log.times[::step].copy(), {role: values[::step].copy() for role, values in log.values.items()})


def case(work):
    """By rate and number: whether the interval contains the truth, and the relative width of the interval. A number that the
    log does not give at all is left out."""
    number, rates = work
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        log, base, true = driven(number, folder)
    for rate in rates:
        numbers = fit.fit_log(slower(log, rate), base).numbers()
        for key in NUMBERS:
            if key in numbers:
                low, high = numbers[key].interval
                unit = 1.0 if key.endswith("dead_zone") else true[key]
                found[rate, key] = (low <= true[key] <= high, (high - low) / unit / 2.0, bool(numbers[key].unsure))
    return found


def table(cases):
    """Lines of the results, and whether all shares are within LOW to HIGH."""
    lines, good = ["| rate, Hz | number | cases | interval contains the truth, % | half width, median | unsure |", "|---|---|---|---|---|---|"], True
    for rate, key in sorted({key for one in cases for key in one}, key=lambda one: (-one[0], NUMBERS.index(one[1]))):
        some = [one[rate, key] for one in cases if (rate, key) in one]
        share = sum(one[0] for one in some) / len(some)
        width = float(np.median([one[1] for one in some]))
        shown = f"{width:.4f}" if key.endswith("dead_zone") else f"{100.0 * width:.2g} %"
        lines.append(f"| {rate} | `{key}` | {len(some)} | {100.0 * share:.1f} | {shown} | {sum(one[2] for one in some)} |")
        error = 2.0 * math.sqrt(0.95 * 0.05 / len(some))
        good = good and LOW - error <= share <= HIGH + error
    return lines, good


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--cases", type=int, default=200)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--rates", default="1000,500,100")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    rates = [int(rate) for rate in options.rates.split(",")]
    with Pool(options.jobs) as pool:
        cases = pool.map(case, [(number, rates) for number in range(options.first, options.first + options.cases)], chunksize=1)
    lines, good = table(cases)
    print("\n".join(lines))
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
