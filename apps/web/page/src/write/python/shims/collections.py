# collections: MicroPython's, with a deque that does all that Python's does, defaultdict and Counter.
from ucollections import OrderedDict, namedtuple


class deque(list):
    def __init__(self, items=(), maxlen=None):
        super().__init__(items)
        self.maxlen = maxlen
        self._cut_first()

    def _cut_first(self):
        while self.maxlen is not None and len(self) > self.maxlen:
            self.pop(0)

    def _cut_last(self):
        while self.maxlen is not None and len(self) > self.maxlen:
            self.pop()

    def append(self, item):
        super().append(item)
        self._cut_first()

    def appendleft(self, item):
        self.insert(0, item)
        self._cut_last()

    def extend(self, items):
        for item in items:
            self.append(item)

    def extendleft(self, items):
        for item in items:
            self.appendleft(item)

    def popleft(self):
        return self.pop(0)

    def rotate(self, n=1):
        for _ in range(n % len(self) if self else 0):
            self.insert(0, self.pop())

    def copy(self):
        return deque(self, self.maxlen)

    def __repr__(self):
        return "deque(%r)" % (list(self),)


class defaultdict(dict):
    def __init__(self, default_factory=None, *more):
        super().__init__(*more)
        self.default_factory = default_factory

    def __getitem__(self, key):
        if key not in self and self.default_factory:
            self[key] = self.default_factory()
        return super().__getitem__(key)

    def copy(self):
        return defaultdict(self.default_factory, self)


class Counter(dict):
    def __init__(self, items=()):
        super().__init__()
        self.update(items)

    def __getitem__(self, key):
        return self.get(key, 0)

    def update(self, items):
        counts = items.items() if isinstance(items, dict) else ((item, 1) for item in items)
        for item, count in counts:
            self[item] = self[item] + count

    def most_common(self, n=None):
        return sorted(self.items(), key=lambda pair: pair[1], reverse=True)[:n]

    def elements(self):
        return (item for item, count in self.items() for _ in range(count))
