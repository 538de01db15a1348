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


def main():
    order = dict(mice=["random", "ariadne-deep", "certify"], runs=int(sys.argv[1]) if len(sys.argv) > 1 else 2000)
    with tempfile.TemporaryDirectory() as folder:
        begin = spent(), time.perf_counter()
        contests = len(labmouse.race(**order, jobs=1, store=f"{folder}/alone.db").table)
        print(f"alone: {contests} contests, {spent() - begin[0]:.2f} s of processor, {time.perf_counter() - begin[1]:.2f} s", flush=True)
        for workers in (1, 2):
            with distributed.LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address="127.0.0.1:0") as local:
                with distributed.Client(local) as client:
                    client.run(spent)
                    before = sum(client.run(spent).values())
                    begin = spent(), time.perf_counter()
                    cluster.race(client, **order, store=f"{folder}/{workers}.db")
                    wall, here = time.perf_counter() - begin[1], spent() - begin[0]
                    there = sum(client.run(spent).values()) - before
                    print(f"{workers} workers: {there:.2f} s of processor in them, {here:.2f} s in client and scheduler, {wall:.2f} s", flush=True)


if __name__ == "__main__":
    main()
