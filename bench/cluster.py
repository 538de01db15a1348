"""What a cluster costs: processor time of one and two workers and of the client, against a race in one process.

Usage: PYTHONPATH=build/release/python build/python-tools/bin/python bench/cluster.py [RUNS]
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


def counted(client):
    """The calls that send a task."""
    sent, submit = [], client.submit
    client.submit = lambda *words, **named: sent.append(words) or submit(*words, **named)
    return sent


def main():
    order = dict(mice=["random", "ariadne-deep", "certify"], runs=int(sys.argv[1]) if len(sys.argv) > 1 else 2000)
    with tempfile.TemporaryDirectory() as folder:
        begin = spent(), time.perf_counter()
        contests = len(labmouse.race(**order, jobs=1, store=f"{folder}/alone.db").table)
        alone = spent() - begin[0]
        print(f"alone: {contests} contests, {alone:.2f} s of processor, {time.perf_counter() - begin[1]:.2f} s", flush=True)
        walls, works = [], []
        for workers in (1, 2):
            with distributed.LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address="127.0.0.1:0") as local:
                with distributed.Client(local) as client:
                    client.run(spent)
                    sent = counted(client)
                    before = sum(client.run(spent).values())
                    begin = spent(), time.perf_counter()
                    cluster.race(client, **order, store=f"{folder}/{workers}.db")
                    walls.append(time.perf_counter() - begin[1])
                    here = spent() - begin[0]
                    works.append(sum(client.run(spent).values()) - before)
                    tasks = len(sent)
                    print(f"{workers} workers: {works[-1]:.2f} s of processor in them, {here:.2f} s in client and scheduler, {walls[-1]:.2f} s;"
                          f" {tasks} tasks of {works[-1] / tasks:.2f} s, of which {1000 * (works[-1] - alone) / tasks:.0f} ms beside contests,"
                          f" and {1000 * here / tasks:.0f} ms in client and scheduler for each", flush=True)
        print(f"two workers against one: {walls[0] / walls[1] / 2:.2f} by the clock, {works[0] / works[1]:.2f} by processor time")


if __name__ == "__main__":
    main()
