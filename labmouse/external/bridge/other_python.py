# Detects robots written for the other major version of Python. Patterns are short, as MicroPython requires.
import re

# By version: lines and names that are only valid in the other version.
OTHER_LINES = {
    3: (r"\s*(print|exec)\s+[\w'\"]", r"\s*print\s*>>", r"\s*except\s.*,\s*\w+\s*:", r"\s*raise\s+\w+\s*,", r".*(<>|`)"),
    2: (r".*\b[fF]['\"]", r".*\bprint\s*\(.*\b(end|sep|file)\s*=", r".*(->|:=)", r"\s*(nonlocal|async)\s",
        r"\s*def\s.*\w\s*:\s*\w.*\)")}
OTHER_NAMES = {
    3: "xrange raw_input unicode basestring long unichr reduce execfile cmp reload has_key iteritems itervalues"
       " iterkeys maxint izip Queue ConfigParser Tkinter tkMessageBox cPickle StringIO cStringIO urllib2",
    2: "queue configparser tkinter builtins enum dataclasses typing pathlib statistics lru_cache FileNotFoundError"}


def missing_name(error):
    """The name, attribute or module that is missing by an error message; None if there is none."""
    named = re.search(r"(name|module named|has no attribute) '?([\w.]+)", str(error))
    return named.group(2) if named else None


def is_for_other(version, kind, error, line):
    """Whether an error indicates a robot for the other Python; `line`: the source line of a syntax error."""
    if issubclass(kind, SyntaxError):
        return any(re.match(pattern, line) for pattern in OTHER_LINES[version])
    names = OTHER_NAMES[version].split()
    return issubclass(kind, (NameError, ImportError, AttributeError)) and missing_name(error) in names
