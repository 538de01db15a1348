# The side of a capstone robot in labmouse's external mouse protocol: what the robot gets, and how its answers are read.
# In syntax that Python 2.7, Python 3 and MicroPython all take: the page plays robots by this text, too.
import sys

CALLED = "it is called as Robot(maze_dim) once, and as next_move(sensors) in each step"


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
        shown = repr(action)[:200]
        sys.exit("next_move returned %s; it has to return (rotation, movement) or ('Reset', 'Reset')" % shown)


def degrees(rotation):
    """A rotation as a whole number. The tester compares it with -90, 0 and 90, so that no value is wrong: any other, even
    text, is no rotation. Of those that are no whole numbers, 1 takes the place."""
    try:
        return within(rotation) if rotation == int(rotation) else 1
    except (TypeError, ValueError, OverflowError):
        return 1


class Dialogue(object):
    """Hears the host line by line. `make` is called once, with the size of the maze and the seed of the contest, and
    returns the robot."""

    def __init__(self, make):
        self.make = make
        self.told = {"size": 0, "seed": 0}
        self.robot = None

    def hear(self, line):
        """What the robot's side says to that line; None where that is nothing."""
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
    """The robot of a module that was loaded from a file of that name."""
    if not hasattr(module, "Robot"):
        sys.exit("%s has no class Robot" % name)
    return module.Robot(size)
