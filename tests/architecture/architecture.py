#!/usr/bin/env python3
"""Compares the tree with the table of rooms in ARCHITECTURE.md.

Usage: architecture.py ROOT
Prints each violation as FILE:LINE: error: REASON and exits with 1 if there is any.
"""
import re
import sys
from pathlib import Path

# Behaviour that depends on the platform, the clock or the standard library has no place where the same bits must come
# out everywhere: these rooms compile for WebAssembly and for microcontrollers.
PORTABLE_ROOMS = ("grid", "chance", "maze", "mouse", "strategies", "contest")
BANNED_HEADERS = ("chrono", "filesystem", "fstream", "iostream", "random", "regex", "thread", "unordered_map",
                  "unordered_set")

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def rooms_of(page):
    """The table as {room: set of the rooms that it may include}, in the order of the page."""
    rooms = {}
    for name, allowed in re.findall(r"^\| (\w+) \| [^|]+ \| ([^|]+) \| [^|]+ \|$", page, re.MULTILINE):
        if name == "room":
            continue
        words = {"all above": list(rooms), "nothing": []}.get(allowed.strip(), allowed.strip().split(", "))
        above = [word for word in words if word not in rooms]
        if above:
            raise ValueError(f"room {name} may include {', '.join(above)}, which the table does not list above it")
        rooms[name] = set(words)
    if not rooms:
        raise ValueError("no table of rooms")
    return rooms


def sources(folder):
    return sorted(path for path in folder.rglob("*") if path.suffix in (".hpp", ".cpp"))


def include_violations(root, rooms):
    for path in sources(root / "labmouse") + sources(root / "apps"):
        parts = path.relative_to(root).parts
        room = "apps" if parts[0] == "apps" else parts[1]
        if room not in rooms:
            yield path, 1, f"{room} is no room of ARCHITECTURE.md"
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if match := INCLUDE.match(line):
                yield from ((path, number, reason) for reason in judged(room, rooms, match[1] == '"', match[2]))


def judged(room, rooms, quoted, header):
    """Why a file of that room may not include that header; nothing if it may."""
    if header.startswith("labmouse/"):
        other = header.split("/")[1]
        if other != room and other not in rooms[room]:
            yield f"{room} must not include {other}: {header}"
    elif quoted and room != "apps":
        yield f'{header} is not named by its path from the root: "labmouse/..."'
    elif ".." in header:
        yield f"{header} climbs out of its folder"
    elif room in PORTABLE_ROOMS and header in BANNED_HEADERS:
        yield f"{room} must not include <{header}>"


def link_violations(root, rooms):
    """labmouse_room(NAME ROOM...) links what the table allows: no less, so that the table is not wider than it has to be."""
    path = root / "CMakeLists.txt"
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if match := re.match(r"\s*labmouse_room\((\w+)([\w\s]*)\)", line):
            name, linked = match[1], set(match[2].split())
            if linked != rooms.get(name):
                wanted = " ".join(sorted(rooms[name])) if name in rooms else "no such room"
                yield path, number, f"{name} links {' '.join(sorted(linked))}, but ARCHITECTURE.md says: {wanted}"


def roster_violations(root):
    """Every RosterEntry that a mind's file defines is on the roster."""
    roster = root / "labmouse/strategies/roster.cpp"
    if not roster.exists():
        return
    listed = set(re.findall(r"&(\w+_mouse)\b", roster.read_text(encoding="utf-8")))
    for path in sources(roster.parent):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            match = re.match(r"\s*const RosterEntry (\w+_mouse)\b", line)
            if match and match[1] not in listed:
                yield path, number, f"{match[1]} is not on the roster"


def violations(root):
    """All violations as lines of text."""
    root = Path(root)
    rooms = rooms_of((root / "ARCHITECTURE.md").read_text(encoding="utf-8"))
    found = [*include_violations(root, rooms), *link_violations(root, rooms), *roster_violations(root)]
    return [f"{path.relative_to(root)}:{number}: error: {reason}" for path, number, reason in found]


if __name__ == "__main__":
    lines = violations(sys.argv[1])
    for line in lines:
        print(line)
    sys.exit(1 if lines else 0)
