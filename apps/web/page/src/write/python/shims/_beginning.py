# Before a robot is loaded: what cannot be mended by a file under a module's own name.
import builtins
import sys

# What is known of the contest.
told = {"seed": 0}

for name, kind in (("RecursionError", RuntimeError), ("ModuleNotFoundError", ImportError), ("FileNotFoundError", OSError),
                   ("IOError", OSError), ("PermissionError", OSError), ("TimeoutError", OSError)):
    setattr(builtins, name, kind)

show = print


def print(*things, sep=" ", end="\n", file=sys.stdout, flush=False):
    """As Python's: MicroPython's own knows no `flush`, of which nothing is needed here."""
    show(*things, sep=sep, end=end, file=file)


def input(prompt=""):
    raise EOFError("nobody answers a robot")


def sorted(items, key=None, reverse=False):
    """As Python's: among equals the first stays the first, which MicroPython's own does not heed."""
    items = list(items)
    keys = [key(item) for item in items] if key else items
    order = list(range(len(items)))
    if reverse:
        order.reverse()
    width = 1
    while width < len(order):
        order = [at for begin in range(0, len(order), 2 * width)
                 for at in merged(order[begin:begin + width], order[begin + width:begin + 2 * width], keys)]
        width *= 2
    if reverse:
        order.reverse()
    return [items[at] for at in order]


def merged(first, second, keys):
    """Two sorted lists of places as one; of equals, those of the first come first."""
    both, at = [], 0
    for place in second:
        while at < len(first) and not keys[place] < keys[first[at]]:
            both.append(first[at])
            at += 1
        both.append(place)
    return both + first[at:]


builtins.input = input
builtins.print = print
builtins.sorted = sorted
# Modules that MicroPython looks up before any file.
sys.modules["math"] = __import__("_math")
sys.modules["sys"] = __import__("_sys")
