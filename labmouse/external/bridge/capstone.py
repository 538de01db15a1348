# Plays a capstone robot by labmouse's external mouse protocol: python -u -c THIS robot.py [ARGUMENT...], in the robot's folder.
# Behind dialogue.py and other_python.py, in one text with them. In syntax that Python 2.7 and Python 3 both take.
import fcntl
import os
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
        """Python 3 asks how to load a module: numpy's random numbers as ever, and then seeded."""
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


def hint(kind, error, called):
    """What to do about an error, where that can be told; `called`: by our call, and not in the robot's own code."""
    major = sys.version_info[0]
    if is_for_other(major, kind, error, getattr(error, "text", None) or ""):
        other = (2, "python2.7") if major == 3 else (3, "python3")
        return ("it seems to be written for Python %d; name its interpreter with --python %s (or `interpreter` in a"
                " mice file)" % other)
    missing = missing_name(error)
    if issubclass(kind, ImportError) and str(error).startswith("No module named") and missing:
        return ("module %s is neither in the robot's folder nor installed for %s (%d.%d.%d); install it there, or name"
                " the interpreter that has it with --python" % ((missing, sys.executable) + sys.version_info[:3]))
    if called and issubclass(kind, (TypeError, AttributeError)):
        return CALLED
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
    sys.dont_write_bytecode = True  # many robots side by side, and nothing of ours in their folder
    dialogue = Dialogue(make)
    line = questions.readline()
    while line:
        said = dialogue.hear(line)
        if said is not None:
            os.write(answers, (said + "\n").encode("ascii"))
        line = questions.readline()


def make(size, seed):
    """The robot that the command line names."""
    sow(seed)
    del sys.argv[0]  # the robot has its own words, as if it had been started by itself
    return robot_of(load(os.path.abspath(sys.argv[0])), sys.argv[0], size)


sys.excepthook = show
main()
