# functools, of which MicroPython has a part.


def partial(function, *first, **named):
    return lambda *more, **others: function(*(first + more), **dict(list(named.items()) + list(others.items())))


def reduce(function, items, *start):
    items = iter(items)
    value = start[0] if start else next(items)
    for item in items:
        value = function(value, item)
    return value


def wraps(wrapped):
    return lambda wrapper: wrapper


def cache(function):
    known = {}

    def cached(*given):
        if given not in known:
            known[given] = function(*given)
        return known[given]

    return cached


def lru_cache(maxsize=128, typed=False):
    return cache(maxsize) if callable(maxsize) else cache


def cmp_to_key(compare):
    class Key:
        def __init__(self, item):
            self.item = item

        def __lt__(self, other):
            return compare(self.item, other.item) < 0

        def __eq__(self, other):
            return compare(self.item, other.item) == 0

    return Key


def total_ordering(kind):
    """Where a class says what is less, MicroPython finds the rest by itself but for `or equal`."""
    if not hasattr(kind, "__le__"):
        kind.__le__ = lambda self, other: self < other or self == other
        kind.__ge__ = lambda self, other: not self < other
    return kind
