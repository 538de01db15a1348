# The labmouse protocol for a capstone robot: passes readings to the robot, and converts its answers. The syntax must be
# valid in Python 2.7, Python 3 and MicroPython, because the page runs robots with this text, too.
import sys

CALLED = "it is called as Robot(maze_dim) once, and as next_move(sensors) in each step"


def within(number):
    """Limits a whole number to what a record can hold."""
    return max(-1000000, min(1000000, int(number)))


def answer(action):
    """The protocol line for a return value of next_move, interpreted as by the tester of the capstone project."""
    try:
        rotation, movement = action
        if (rotation, movement) == ("Reset", "Reset"):
            return "reset"
        abs(movement)  # fails for text, as in the tester; int() would accept it
        return "move %d %d" % (degrees(rotation), within(movement))
    except (TypeError, ValueError, OverflowError):
        shown = repr(action)[:200]
        sys.exit("next_move returned %s; it has to return (rotation, movement) or ('Reset', 'Reset')" % shown)


def degrees(rotation):
    """A rotation as a whole number. The tester compares it with -90, 0 and 90, so any other value, even text, means no
    rotation. Values that are no whole numbers become 1."""
    try:
        return within(rotation) if rotation == int(rotation) else 1
    except (TypeError, ValueError, OverflowError):
        return 1


class Dialogue(object):
    """Answers the lines of labmouse. `make` is called once, with the size of the maze and the seed of the contest, and
    returns the robot."""

    def __init__(self, make):
        self.make = make
        self.told = {"size": 0, "seed": 0}
        self.robot = None

    def hear(self, line):
        """The answer to a line; None if there is none."""
        words = line.split()
        if self.robot is not None:
            return answer(self.robot.next_move([int(word) for word in words[1:]]))
        if words[0] in self.told:
            self.told[words[0]] = int(words[1])
        if words[0] != "begin":
            return None
        self.robot = self.make(self.told["size"], self.told["seed"])
        return "labmouse 1"


def robot_of(module, name, size):
    """Creates the robot of a module; `name`: its file, for the message."""
    if not hasattr(module, "Robot"):
        sys.exit("%s has no class Robot" % name)
    return module.Robot(size)
