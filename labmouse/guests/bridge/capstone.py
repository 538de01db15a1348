# Plays a capstone robot by labmouse's guest protocol: python -u -c THIS robot.py, in the robot's folder.
# In syntax that Python 2.7 and Python 3 both take.
import os
import sys


def load(path):
    """The module in that file, under the file's own name."""
    sys.path.insert(0, os.path.dirname(os.path.abspath(path)))
    name = os.path.splitext(os.path.basename(path))[0]
    if sys.version_info[0] == 2:
        import imp
        return imp.load_source(name, path)
    import importlib.util
    spec = importlib.util.spec_from_file_location(name, path)
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


def whole(number):
    """A number as the tester of the capstone project reads a movement."""
    return max(-1000000, min(1000000, int(number)))


def answer(action):
    """The line for what next_move returned."""
    try:
        rotation, movement = action
        if str(rotation) == "Reset" and str(movement) == "Reset":
            return "reset"
        # A rotation by a part of a degree is none that is performed; 1 stands for all of those.
        turn = whole(rotation) if rotation == int(rotation) else 1
        return "move %d %d" % (turn, whole(movement))
    except (TypeError, ValueError, OverflowError):
        sys.exit("next_move returned %r; it has to return (rotation, movement) or ('Reset', 'Reset')" % (action,))


def main():
    questions = os.fdopen(os.dup(0), "r")
    answers = os.dup(1)
    # What the robot prints goes to the log, and what it wants to read is empty: neither touches the protocol.
    os.dup2(2, 1)
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    size = 0
    line = questions.readline()
    while line and line != "begin\n":
        words = line.split()
        if words[0] == "size":
            size = int(words[1])
        line = questions.readline()
    module = load(sys.argv[1])
    if not hasattr(module, "Robot"):
        sys.exit("%s has no class Robot" % sys.argv[1])
    robot = module.Robot(size)
    os.write(answers, b"labmouse 1\n")
    line = questions.readline()
    while line:
        action = robot.next_move([int(word) for word in line.split()[1:]])
        os.write(answers, (answer(action) + "\n").encode("ascii"))
        line = questions.readline()


main()
