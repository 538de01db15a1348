"""The command `labmouse`: runs the program that came with the package."""

import os
import sys
from pathlib import Path


def main() -> None:
    """Runs the program in place of this process, with the same arguments."""
    name = "labmouse.exe" if os.name == "nt" else "labmouse"
    program = str(Path(__file__).parent / "bin" / name)
    os.environ.setdefault("LABMOUSE_PYTHON", sys.executable)
    if os.name == "nt":
        import subprocess

        sys.exit(subprocess.call([program, *sys.argv[1:]]))
    os.execv(program, ["labmouse", *sys.argv[1:]])


if __name__ == "__main__":
    main()
