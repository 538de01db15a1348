# queue, which MicroPython lacks, for one thread: nobody would fill an empty queue.
from heapq import heappop, heappush
from collections import deque


class Empty(Exception):
    pass


class Queue:
    def __init__(self, maxsize=0):
        self.queue = self._make()

    def _make(self):
        return deque()

    def _take(self):
        return self.queue.popleft()

    def put(self, item, *how):
        self.queue.append(item)

    def get(self, *how):
        if not self.queue:
            raise Empty()
        return self._take()

    put_nowait, get_nowait = put, get

    def qsize(self):
        return len(self.queue)

    def empty(self):
        return not self.queue

    def full(self):
        return False


class LifoQueue(Queue):
    def _take(self):
        return self.queue.pop()


class PriorityQueue(Queue):
    def _make(self):
        return []

    def _take(self):
        return heappop(self.queue)

    def put(self, item, *how):
        heappush(self.queue, item)

    put_nowait = put


SimpleQueue = Queue
