"""The command `labmouse`: runs the program in the package's folder `bin`."""

import os
import sys
from pathlib import Path


def main() -> None:
    """Replaces this process by the program, with the same arguments (on Windows: runs it and returns its exit code)."""
    name = "labmouse.exe" if os.name == "nt" else "labmouse"
    program = str(Path(__file__).parent / "bin" / name)
    os.environ.setdefault("LABMOUSE_PYTHON", sys.executable)
    if os.name == "nt":
        import subprocess

        sys.exit(subprocess.call([program, *sys.argv[1:]]))
    os.execv(program, ["labmouse", *sys.argv[1:]])


if __name__ == "__main__":
    main()
