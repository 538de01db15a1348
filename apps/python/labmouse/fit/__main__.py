"""`python -m labmouse.fit`: the command `labmouse robot fit`."""

import sys

from ._commands import fit

if __name__ == "__main__":
    sys.exit(fit(sys.argv[1:]))
