"""Overhead of a cluster: wall-clock and processor time of one and two workers and of the client.

Usage: PYTHONPATH=build/release/python build/python-tools/bin/python bench/cluster.py [RUNS]

Also measures the race in one process with one and two threads: two workers cannot gain more than two threads.
"""

import os
import sys
import tempfile
import time

import distributed
import labmouse
from labmouse import cluster


def spent():
    times = os.times()
    return times.user + times.system


def timed(call):
    """The processor time of this process and the wall-clock time of a call, in s."""
    begin = spent(), time.perf_counter()
    call()
    return spent() - begin[0], time.perf_counter() - begin[1]


def tasks_of(client):
    """The duration of each finished task in s."""
    return [part["stop"] - part["start"] for task in client.get_task_stream() for part in task["startstops"] if part["action"] == "compute"]


def quantiles(tasks):
    """Quantiles 0.1, 0.5 and 0.9 of task durations in s, weighted by the duration."""
    tasks, done, found = sorted(tasks), 0.0, []
    for task in tasks:
        done += task
        found += [task] * (sum(done >= share * sum(tasks) for share in (0.1, 0.5, 0.9)) - len(found))
    return found


def main():
    order = dict(mice=["random", "ariadne-deep", "certify"], runs=int(sys.argv[1]) if len(sys.argv) > 1 else 2000)
    with tempfile.TemporaryDirectory() as folder:
        alone, clocks, works, shares = 0.0, [], [], []
        for threads in (1, 2):
            work, clock = timed(lambda: labmouse.race(**order, jobs=threads, progress=False, store=f"{folder}/threads-{threads}.db"))
            alone = alone or work
            clocks.append(clock)
            print(f"alone, {threads} threads: {work:.2f} s of processor, {clock:.2f} s", flush=True)
        print(f"two threads against one: {clocks[0] / clocks[1] / 2:.2f} by the clock")
        clocks.clear()
        for workers in (1, 2):
            with distributed.LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address="127.0.0.1:0") as local:
                with distributed.Client(local) as client:
                    client.wait_for_workers(workers)
                    client.run(cluster.race.__module__.__len__)  # workers import labmouse
                    client.get_task_stream()
                    before = sum(client.run(spent).values())
                    here, clock = timed(lambda: cluster.race(client, **order, progress=False, store=f"{folder}/workers-{workers}.db"))
                    works.append(sum(client.run(spent).values()) - before)
                    clocks.append(clock)
                    tasks = tasks_of(client)
                    shares.append(sum(tasks) / workers / clock)
                    low, middle, high = quantiles(tasks)
                    print(f"{workers} workers: {works[-1]:.2f} s of processor in them, {here:.2f} s in client and scheduler, {clock:.2f} s,"
                          f" {100 * shares[-1]:.1f} % of which each was in a task;"
                          f" {len(tasks)} tasks; half of the work in those of {middle:.2f} s or more, four fifths in those of {low:.2f} to {high:.2f} s;"
                          f" for each {1000 * (works[-1] - alone) / len(tasks):.0f} ms in its worker beside contests,"
                          f" and {1000 * here / len(tasks):.0f} ms in client and scheduler", flush=True)
        print(f"two workers against one: {clocks[0] / clocks[1] / 2:.2f} by the clock, {works[0] / works[1]:.2f} by processor time,"
              f" {works[0] / works[1] * shares[1] / shares[0]:.2f} by that and by how long they were in tasks, as where each has a processor of its own")


if __name__ == "__main__":
    main()
