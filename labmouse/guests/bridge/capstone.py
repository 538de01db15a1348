# Plays a capstone robot by labmouse's guest protocol: python -u -c THIS robot.py [ARGUMENT...], in the robot's folder.
# In syntax that Python 2.7 and Python 3 both take.
import fcntl
import os
import re
import sys
import traceback


def load(path):
    """The module in that file, under the file's own name, however that ends."""
    sys.path.insert(0, os.path.dirname(path))
    name = os.path.splitext(os.path.basename(path))[0]
    if sys.version_info[0] == 2:
        import imp
        return imp.load_source(name, path)
    import importlib.machinery
    import importlib.util
    spec = importlib.util.spec_from_loader(name, importlib.machinery.SourceFileLoader(name, path))
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


def sow(seed):
    """Lets chance repeat itself: whatever asks the system for a seed, in `random` or in numpy, gets one that follows from
    the contest's. Seeds that the robot chooses itself stay."""
    import random
    source = random.Random(seed)
    given = random.Random.seed

    def urandom(count):
        return bytes(bytearray(source.getrandbits(8) for _ in range(count)))

    def seeded(self, a=None, *more, **named):
        given(self, source.getrandbits(64) if a is None else a, *more, **named)

    os.urandom = random._urandom = urandom
    random.Random.seed = seeded
    random.seed = random._inst.seed
    random.seed(seed)
    sys.meta_path.insert(0, NumpySower(lambda: source.getrandbits(32)))


class NumpySower(object):
    """Sows numpy's dice as they are imported, before anybody throws them; robots without numpy load none."""

    def __init__(self, next_seed):
        self.next_seed = next_seed

    def find_spec(self, name, path=None, target=None):
        """Python 3 asks how to load a module: numpy's dice as ever, and then they are sown."""
        if name != "numpy.random":
            return None
        import importlib.machinery
        spec = importlib.machinery.PathFinder.find_spec(name, path)
        load = spec.loader.exec_module

        def load_and_sow(module):
            load(module)
            self.sow(module)

        spec.loader.exec_module = load_and_sow
        return spec

    def find_module(self, name, path=None):
        """Python 2 asks who loads a module, and then has it loaded."""
        return self if name == "numpy.random" else None

    def load_module(self, name):
        sys.meta_path.remove(self)
        __import__(name)
        self.sow(sys.modules[name])
        return sys.modules[name]

    def sow(self, dice):
        if not hasattr(dice, "SeedSequence"):
            self.sow_old(dice)
        dice.seed(self.next_seed())

    def sow_old(self, dice):
        """Before 1.17, numpy gets its seeds from the system in C, where nothing can be put in between."""
        next_seed, plain, shared = self.next_seed, dice.RandomState, dice.seed

        class RandomState(plain):
            def __init__(self, seed=None):
                plain.__init__(self, next_seed() if seed is None else seed)

            def seed(self, seed=None):
                plain.seed(self, next_seed() if seed is None else seed)

        dice.RandomState = RandomState
        dice.seed = lambda seed=None: shared(next_seed() if seed is None else seed)


def within(number):
    """What a record can hold of a whole number."""
    return max(-1000000, min(1000000, int(number)))


def answer(action):
    """The line for what next_move returned, judged as the tester of the capstone project judges it."""
    try:
        rotation, movement = action
        if (rotation, movement) == ("Reset", "Reset"):
            return "reset"
        abs(movement)  # the tester's own first look: of text, which int() would take, there is no size
        return "move %d %d" % (degrees(rotation), within(movement))
    except (TypeError, ValueError, OverflowError):
        sys.exit("next_move returned %.200r; it has to return (rotation, movement) or ('Reset', 'Reset')" % (action,))


def degrees(rotation):
    """A rotation as a whole number. The tester compares it with -90, 0 and 90, so that no value is wrong: any other, even
    text, is no rotation. Of those that are no whole numbers, 1 takes the place."""
    try:
        return within(rotation) if rotation == int(rotation) else 1
    except (TypeError, ValueError, OverflowError):
        return 1


# Of the Python that runs, the other one: its version, its interpreter, and lines and names that only it has.
OTHER_PYTHON = {
    3: (2, "python2.7",
        r"\s*(print|exec)\s+[\w'\"]|\s*print\s*>>|\s*except\s.*,\s*\w+\s*:|\s*raise\s+\w+\s*,|.*(<>|`)",
        "xrange raw_input unicode basestring long unichr reduce execfile cmp reload has_key iteritems itervalues"
        " iterkeys maxint izip Queue ConfigParser Tkinter tkMessageBox cPickle StringIO cStringIO urllib2"),
    2: (3, "python3",
        r".*\b[fF]['\"]|.*\bprint\s*\(.*\b(end|sep|file)\s*=|.*(->|:=)|\s*(nonlocal|async)\s|\s*def\s.*\w\s*:\s*\w.*\)",
        "queue configparser tkinter builtins enum dataclasses typing pathlib statistics lru_cache FileNotFoundError")}


def hint(kind, error, called):
    """What to do about an error, where that can be told; `called`: by our call, and not in the robot's own code."""
    version, interpreter, lines, names = OTHER_PYTHON[sys.version_info[0]]
    named = re.search(r"(?:name|module named|has no attribute) '?([\w.]+)", str(error))
    if issubclass(kind, SyntaxError):
        other = re.match(lines, error.text or "")
    else:
        other = issubclass(kind, (NameError, ImportError, AttributeError)) and named and named.group(1) in names.split()
    if other:
        return ("it seems to be written for Python %d; name its interpreter with --python %s (or `interpreter` in a"
                " lineup file)" % (version, interpreter))
    if issubclass(kind, ImportError) and str(error).startswith("No module named") and named:
        return ("module %s is neither in the robot's folder nor installed for %s (%d.%d.%d); install it there, or name"
                " the interpreter that has it with --python" % ((named.group(1), sys.executable) + sys.version_info[:3]))
    if called and issubclass(kind, (TypeError, AttributeError)):
        return "it is called as Robot(maze_dim) once, and as next_move(sensors) in each step"
    return ""


def show(kind, error, trace):
    """Shows an error of the robot without the frames of this script and of Python's own loader."""
    while trace and trace.tb_frame.f_code.co_filename.startswith("<"):
        trace = trace.tb_next
    traceback.print_exception(kind, error, trace)
    words = hint(kind, error, called=trace is None)
    if words:
        sys.stderr.write("hint: %s\n" % words)


def main():
    asked, answers = os.dup(0), os.dup(1)
    for end in (asked, answers):  # in Python 2, programs that the robot starts would hold them, too
        fcntl.fcntl(end, fcntl.F_SETFD, fcntl.FD_CLOEXEC)
    questions = os.fdopen(asked, "r")
    # What the robot prints goes to the log, and what it wants to read is empty: neither touches the protocol.
    os.dup2(2, 1)
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    size = seed = 0
    line = questions.readline()
    while line and line != "begin\n":
        words = line.split()
        if words[0] == "size":
            size = int(words[1])
        if words[0] == "seed":
            seed = int(words[1])
        line = questions.readline()
    sys.dont_write_bytecode = True  # many robots side by side, and nothing of ours in their folder
    sow(seed)
    del sys.argv[0]  # the robot has its own words, as if it had been started by itself
    module = load(os.path.abspath(sys.argv[0]))
    if not hasattr(module, "Robot"):
        sys.exit("%s has no class Robot" % sys.argv[0])
    robot = module.Robot(size)
    os.write(answers, b"labmouse 1\n")
    line = questions.readline()
    while line:
        action = robot.next_move([int(word) for word in line.split()[1:]])
        os.write(answers, (answer(action) + "\n").encode("ascii"))
        line = questions.readline()


sys.excepthook = show
main()
