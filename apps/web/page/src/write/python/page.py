# Plays robot.py in the page: behind dialogue.py and other_python.py of the command line's bridge, in one text with them.
import gc
import io
import json
import sys

# Where all of Python is.
COMMAND = "labmouse run %scapstone:robot.py capstone-1"


def make(size, seed):
    """The robot in robot.py. Its dice follow from the seed, as on the command line."""
    __import__("_beginning").told["seed"] = seed
    return robot_of(__import__("robot"), "robot.py", size)


def hear(line):
    """What the robot says to a line of the host, as JSON: `said`, or `failed` with the `line` of robot.py."""
    try:
        return json.dumps({"said": dialogue.hear(line)})
    except BaseException as error:
        return json.dumps(failure(error))


def failure(error):
    """What is shown of an error, and where in robot.py it was. Prints the way there."""
    if isinstance(error, MemoryError):  # without what the robot holds, there is memory to speak of it
        dialogue.robot = None
        sys.modules.pop("robot", None)
    gc.collect()
    way = [frame for frame in traceback(error) if not frame.startswith('  File "<')]
    places = [int(frame.split(", ")[1].split()[1]) for frame in way if frame.startswith('  File "robot.py"')]
    line = places[-1] if places else None
    if isinstance(error, SystemExit):
        text = error.args and isinstance(error.args[0], str) and error.args[0]
        return {"failed": text or "robot.py ended itself by sys.exit()", "line": line}
    print("\n".join(way if len(way) < 30 else way[:10] + ["  ..."] + way[-15:]))
    kind, text = type(error).__name__, " ".join(str(error).split())
    advice = hint(error, line)
    return {"failed": kind + (": " + text if text else "") + ("; " + advice if advice else ""), "line": line}


def traceback(error):
    """The lines that Python prints for an error."""
    shown = io.StringIO()
    sys.print_exception(error, shown)
    return shown.getvalue().rstrip().split("\n")


def hint(error, line):
    """What to do about an error, where that can be told; `line` of robot.py."""
    kind, missing = type(error), missing_name(error)
    with open("/robot/robot.py") as file:
        text = file.read().split("\n")[line - 1] if line else ""
    if is_for_other(3, kind, error, text):
        return "it seems to be written for Python 2; on the command line: " + COMMAND % "--python python2.7 "
    if issubclass(kind, ImportError) and missing:
        module = missing.split(".")[0]
        return "it needs %s, which the page does not have; on the command line: %s" % (module, COMMAND % "")
    if issubclass(kind, SyntaxError) and (re.match(NEWER, text) or "*x" in str(error)):
        return "MicroPython, which runs Python in the page, does not know this; on the command line: " + COMMAND % ""
    if issubclass(kind, AttributeError) and re.match(r"'(str|list|dict|set|tuple|module)' ", str(error)):
        return "MicroPython, which runs Python in the page, lacks some; on the command line: " + COMMAND % ""
    if issubclass(kind, MemoryError):
        return "a robot in the page has 256 MB, and what it drops is free only after the step"
    if issubclass(kind, (TypeError, AttributeError)) and line is None:
        return CALLED
    return ""


# Syntax that Python knows and MicroPython does not.
NEWER = r"\s*(match|case)\s|.*[[{]\s*\*|\s*class\s.*="

dialogue = Dialogue(make)
