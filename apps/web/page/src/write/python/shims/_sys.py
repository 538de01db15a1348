# sys, with what MicroPython lacks of it.
from io import StringIO
from sys import *

executable = ""
stdin = StringIO("")  # empty, as on the command line


def getrecursionlimit():
    return 1000


def setrecursionlimit(limit):
    """MicroPython's own limit stays."""
