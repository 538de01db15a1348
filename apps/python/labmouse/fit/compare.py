"""`python -m labmouse.fit.compare`: the command `labmouse robot compare`."""

import sys

from ._commands import compare

if __name__ == "__main__":
    sys.exit(compare(sys.argv[1:]))
