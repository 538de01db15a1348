# itertools, of which MicroPython has a part.


def accumulate(items, function=lambda a, b: a + b):
    value, begun = None, False
    for item in items:
        value, begun = function(value, item) if begun else item, True
        yield value


class chain:
    def __init__(self, *lists):
        self.items = chain.from_iterable(lists)

    def __iter__(self):
        return self.items

    def __next__(self):
        return next(self.items)

    @staticmethod
    def from_iterable(lists):
        for items in lists:
            for item in items:
                yield item


def combinations(items, r):
    items = tuple(items)
    if r == 0:
        yield ()
    for at in range(len(items) - r + 1 if r else 0):
        for rest in combinations(items[at + 1:], r - 1):
            yield (items[at],) + rest


def count(start=0, step=1):
    while True:
        yield start
        start += step


def cycle(items):
    items = list(items)
    while items:
        for item in items:
            yield item


def dropwhile(test, items):
    dropping = True
    for item in items:
        dropping = dropping and test(item)
        if not dropping:
            yield item


def groupby(items, key=lambda item: item):
    group = []
    for item in items:
        if group and key(item) != key(group[0]):
            yield key(group[0]), iter(group)
            group = []
        group.append(item)
    if group:
        yield key(group[0]), iter(group)


def islice(items, *bounds):
    start, stop, step = (0,) + bounds + (1,) if len(bounds) == 1 else (bounds + (1,))[:3]
    start, step, at = start or 0, step or 1, 0
    if stop is not None and stop <= start:
        return
    for item in items:
        if at >= start and (at - start) % step == 0:
            yield item
        at += 1
        if stop is not None and at >= stop:
            return


def permutations(items, r=None):
    items = tuple(items)
    r = len(items) if r is None else r
    if r == 0:
        yield ()
    for at in range(len(items) if 0 < r <= len(items) else 0):
        for rest in permutations(items[:at] + items[at + 1:], r - 1):
            yield (items[at],) + rest


def product(*lists, repeat=1):
    results = [()]
    for items in [tuple(items) for items in lists] * repeat:
        results = [result + (item,) for result in results for item in items]
    return iter(results)


def repeat(item, times=None):
    while times is None or times > 0:
        yield item
        times = None if times is None else times - 1


def starmap(function, items):
    for item in items:
        yield function(*item)


def takewhile(test, items):
    for item in items:
        if not test(item):
            return
        yield item


def tee(items, n=2):
    items = list(items)
    return tuple(iter(items) for _ in range(n))


def zip_longest(*lists, fillvalue=None):
    lists = [list(items) for items in lists]
    for at in range(max([len(items) for items in lists] or [0])):
        yield tuple(items[at] if at < len(items) else fillvalue for items in lists)
