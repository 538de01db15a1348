# Runs a capstone robot by the labmouse protocol: python -u -c THIS robot.py [ARGUMENT...], in the robot's folder.
# It is appended to dialogue.py and other_python.py. The syntax must be valid in both Python 2.7 and Python 3.
import fcntl
import os
import sys
import traceback


def load(path):
    """Loads a file as a module of the same name; the file may have any extension."""
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
    """Makes random numbers reproducible: a seed requested from the system, in `random` or in numpy, is derived from the
    seed of the contest. Seeds that the robot sets itself are kept."""
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
    """Seeds numpy.random when it is imported; robots without numpy do not load it."""

    def __init__(self, next_seed):
        self.next_seed = next_seed

    def find_spec(self, name, path=None, target=None):
        """Import hook of Python 3: loads numpy.random as usual, then seeds it."""
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
        """Import hook of Python 2; load_module() then loads it."""
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
        """Seeds numpy before 1.17, which requests system seeds in C, where urandom() cannot be replaced."""
        next_seed, plain, shared = self.next_seed, dice.RandomState, dice.seed

        class RandomState(plain):
            def __init__(self, seed=None):
                plain.__init__(self, next_seed() if seed is None else seed)

            def seed(self, seed=None):
                plain.seed(self, next_seed() if seed is None else seed)

        dice.RandomState = RandomState
        dice.seed = lambda seed=None: shared(next_seed() if seed is None else seed)


def hint(kind, error, called):
    """A hint about an error, or an empty string. `called`: raised by the call of the robot, not in its own code."""
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
    for end in (asked, answers):  # in Python 2, programs that the robot starts would inherit them
        fcntl.fcntl(end, fcntl.F_SETFD, fcntl.FD_CLOEXEC)
    questions = os.fdopen(asked, "r")
    # The robot prints to the log, and reads from an empty input, so that it cannot disturb the protocol.
    os.dup2(2, 1)
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    sys.dont_write_bytecode = True  # many robots may run at once; write no files to their folder
    dialogue = Dialogue(make)
    line = questions.readline()
    while line:
        said = dialogue.hear(line)
        if said is not None:
            os.write(answers, (said + "\n").encode("ascii"))
        line = questions.readline()


def make(size, seed):
    """Creates the robot of the file in the command line."""
    sow(seed)
    del sys.argv[0]  # so that the robot sees its own arguments
    return robot_of(load(os.path.abspath(sys.argv[0])), sys.argv[0], size)


sys.excepthook = show
main()
