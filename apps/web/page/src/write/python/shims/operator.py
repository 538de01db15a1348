# operator, of which MicroPython has a part.


def itemgetter(*keys):
    return lambda x: x[keys[0]] if len(keys) == 1 else tuple([x[key] for key in keys])


def attrgetter(*names):
    return lambda x: getattr(x, names[0]) if len(names) == 1 else tuple([getattr(x, name) for name in names])


add, sub, mul = lambda a, b: a + b, lambda a, b: a - b, lambda a, b: a * b
truediv, floordiv, mod = lambda a, b: a / b, lambda a, b: a // b, lambda a, b: a % b
eq, ne, lt = lambda a, b: a == b, lambda a, b: a != b, lambda a, b: a < b
le, gt, ge = lambda a, b: a <= b, lambda a, b: a > b, lambda a, b: a >= b
neg, not_, contains = lambda a: -a, lambda a: not a, lambda a, b: b in a
