# heapq: MicroPython's, with the rest of Python's.
from uheapq import *


def heappushpop(heap, item):
    heappush(heap, item)
    return heappop(heap)


def heapreplace(heap, item):
    least = heappop(heap)
    heappush(heap, item)
    return least


def nsmallest(n, items, key=None):
    return sorted(items, key=key)[:n]


def nlargest(n, items, key=None):
    return sorted(items, key=key, reverse=True)[:n]


def merge(*lists):
    return iter(sorted(item for items in lists for item in items))
