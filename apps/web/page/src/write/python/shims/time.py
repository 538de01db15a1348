# time: MicroPython's, with Python's clocks.
from utime import *


def perf_counter():
    return time()


monotonic = process_time = clock = perf_counter


def perf_counter_ns():
    return time_ns()
