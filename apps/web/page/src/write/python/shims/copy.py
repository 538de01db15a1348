# copy: MicroPython's own copies no sets.
_PLAIN = (int, float, complex, bool, str, bytes, type(None), type, type(lambda: 0), type(len), range)
error = Error = TypeError


def copy(x):
    if isinstance(x, _PLAIN) or type(x) in (tuple, frozenset):
        return x
    if hasattr(x, "__copy__"):
        return x.__copy__()
    if hasattr(x, "copy"):
        return x.copy()
    return _instance(x, lambda value: value)


def deepcopy(x, memo=None):
    memo = {} if memo is None else memo
    if isinstance(x, _PLAIN):
        return x
    if id(x) not in memo:
        memo[id(x)] = (x, _deep(x, memo))  # x too, so that nothing else gets its number meanwhile
    return memo[id(x)][1]


def _deep(x, memo):
    if hasattr(x, "__deepcopy__"):
        return x.__deepcopy__(memo)
    if type(x) in (tuple, set, frozenset):
        return type(x)([deepcopy(item, memo) for item in x])
    if isinstance(x, list):
        twin = copy(x)
        memo[id(x)] = (x, twin)
        twin[:] = [deepcopy(item, memo) for item in x]
        return twin
    if isinstance(x, dict):
        twin = copy(x)
        memo[id(x)] = (x, twin)
        twin.clear()
        for key, value in x.items():
            twin[deepcopy(key, memo)] = deepcopy(value, memo)
        return twin
    return _instance(x, lambda value: deepcopy(value, memo), memo)


def _instance(x, copied, memo=None):
    twin = object.__new__(type(x))
    if memo is not None:
        memo[id(x)] = (x, twin)
    for name, value in x.__dict__.items():
        setattr(twin, name, copied(value))
    return twin
