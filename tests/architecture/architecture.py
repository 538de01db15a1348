#!/usr/bin/env python3
"""Compares the tree with the tables of modules and packages in docs/contributing/architecture.md.

Usage: architecture.py ROOT
Prints each violation as FILE:LINE: error: REASON and exits with 1 if there is any.
"""
import re
import sys
from pathlib import Path

# Behaviour that depends on the platform, the clock or the standard library has no place where the same bits must come
# out everywhere: these modules compile for WebAssembly and for microcontrollers.
PORTABLE_MODULES = ("functions", "hardware", "grid", "chance", "maze", "mouse", "body", "controller", "strategies",
                  "contest")
BANNED_HEADERS = ("chrono", "filesystem", "fstream", "iostream", "random", "regex", "thread", "unordered_map",
                  "unordered_set")

# A package with more files than that has a second purpose.
MOST_FILES_IN_A_PACKAGE = 40

# What serves all worlds names none of them: they are values there, and stand in one list. The packages and commands below
# are about one or some of them; some more files name one for another reason.
WORLD_PACKAGES = ("steps", "drive", "mms")
ABOUT_WORLDS = WORLD_PACKAGES + ("records", "replays", "shapes", "failure_rates", "drives", "routes", "hindsight")
COMMANDS_ABOUT_WORLDS = ("robot", "rules", "failure_rates", "drive", "route", "mms")
NAME_A_WORLD = {
    "labmouse/lab/worlds/list.cpp": "is the list",
    "labmouse/lab/mice/specs.cpp": "mms: is a kind of mouse, and parameters have worlds in which they count",
    "labmouse/lab/mice_files/mice_file.cpp": "mms is a kind of mouse",
    "labmouse/lab/mice_files/mice_scan.cpp": "mms is a kind of mouse",
    "labmouse/lab/races/earlier_results.hpp": "reads what earlier versions wrote",
    "labmouse/lab/page/about.cpp": "has an example",
    "labmouse/lab/page/external_calls.cpp": "asks programs for steps",
    "apps/python/briefing.cpp": "tells a mouse what it decides in",
    "apps/python/labmouse/learn/mouse.py": "learns in steps alone",
    "apps/web/page/src/home/pairs.ts": "has examples",
    "apps/web/page/src/player/layers.ts": "has a layer of what programs for mms draw",
    "apps/web/page/src/player/legend.tsx": "has a layer of what programs for mms draw",
}
NAMES = "steps|strides|seconds|physical|failures|mms"
TEXT = re.compile(r"\"((?:[^\"\\]|\\.)*)\"|'((?:[^'\\]|\\.)*)'|`([^`]*)`")
WORLD_NAME = re.compile(rf"^(strides|physical|failures|mms)$|\b({NAMES}) world\b|\bworld (?:in |of )?({NAMES})\b|^In ({NAMES}):")
WORLD_VALUE = re.compile(rf"\bworld\W{{1,8}}(?:name: )?[\"'`]({NAMES})[\"'`]")
EXAMPLE = re.compile(r"\blabmouse [a-z]+ ")
# A variable that outlives its function: one that the compiler has not fixed is state that strategies could share, and often
# takes memory when it is first met. A function has a parenthesis before any of `=;{`, and no values in it.
FIXED = r"(?:constexpr|constinit const)\b"
NO_VALUES = r"(?!\s*(?:[\d\"'&]|(?!int|bool|char|float|double|unsigned|auto)[a-z]\w*\s*[,)]))"
STATIC = re.compile(rf"^\s*(?:inline\s+)?static\s+(?!{FIXED})(?![^(=;{{]*\({NO_VALUES})")
WORDS_OF_NO_VARIABLE = ("namespace|using|template|class|struct|enum|union|static_assert|friend|typedef|return|public"
                        "|private|protected|extern (?:const|template|\"C)")
# What stands at the beginning of a line is in no function and no class.
GLOBAL = re.compile(rf"^(?!(?:{WORDS_OF_NO_VARIABLE})\b|(?:inline )?{FIXED})"
                    r"[A-Za-z_][^()]*[\w>&*\]]\s+\w+(?:\[[^]]*\])*\s*(?:=[^=]|=$|;|\{)")

# Calls of one system: only in these files, which know that there are others, and in what a build without external mice leaves out.
SYSTEM_HEADER = re.compile(r"(sys|linux|net|netinet|arpa)/|(unistd|fcntl|poll|netdb|signal|pthread|sched|spawn|dirent|termios|dlfcn|pwd"
                           r"|grp|glob|io|process|windows)\.h$")
SYSTEM_FILES = ("labmouse/lab/system/calls.cpp", "labmouse/lab/system/live_source.cpp", "labmouse/lab/system/page_server.cpp",
                "apps/cli/terminal.cpp")

# Numbers are read in one file. The readers of the standard library differ by platform and by locale, and so do printf and
# streams where they write numbers with a point; {fmt} does not.
NUMBER_FILE = "labmouse/functions/parse_number.hpp"
NUMBER_READER = re.compile(r"\b(strto[dflu]\w*|sto(?:[dfil]|l[dl]|ull?)|ato(?:[fil]|ll)|from_chars|v?[fs]?w?scanf)\b\s*[(<]")
NUMBER_WRITER = re.compile(r"(\w*printf)\s*\(.*%[-+ #0-9.*']*L?[aefgAEFG]")
NUMBER_STREAM = re.compile(r"\b(\w*stream)\b[^;]*[)}]\s*>>")
STREAM_HEADERS = ("iomanip", "iostream", "istream", "locale", "ostream", "sstream")

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def modules_of(page):
    """The table as {module: set of the modules that it may include}, in the order of the page."""
    modules = {}
    for name, allowed in re.findall(r"^\| (\w+) \| [^|]+ \| ([^|]+) \| [^|]+ \|$", page, re.MULTILINE):
        if name == "module":
            continue
        words = {"all above": list(modules), "nothing": []}.get(allowed.strip(), allowed.strip().split(", "))
        above = [word for word in words if word not in modules]
        if above:
            raise ValueError(f"module {name} may include {', '.join(above)}, which the table does not list above it")
        modules[name] = set(words)
    if not modules:
        raise ValueError("no table of modules")
    return modules


def packages_of(page):
    """The second table as {module/package: the packages of the same module that it includes}, in the order of the page."""
    packages = {}
    for name, included in re.findall(r"^\| (\w+/\w+) \| [^|]+ \| ([^|]+) \|$", page, re.MULTILINE):
        module = name.split("/")[0]
        words = [] if included.strip() == "nothing" else [f"{module}/{word}" for word in included.strip().split(", ")]
        above = [word for word in words if word not in packages]
        if above:
            raise ValueError(f"package {name} includes {', '.join(above)}, which the table does not list above it")
        packages[name] = set(words)
    return packages


def sources(folder):
    return sorted(path for path in folder.rglob("*") if path.suffix in (".hpp", ".cpp"))


def library(root, module=""):
    """The files of the library, or of one module: headers that are installed lie in include/, others beside their sources."""
    return sources(root / "include/labmouse" / module) + sources(root / "labmouse" / module)


def name_of(path, root):
    """The file as an #include names it, wherever it lies."""
    return path.relative_to(root).as_posix().removeprefix("include/")


def include_violations(root, modules):
    for path in library(root) + sources(root / "apps"):
        parts = name_of(path, root).split("/")
        module = "apps" if parts[0] == "apps" else parts[1]
        if module not in modules:
            yield path, 1, f"{module} is no module of docs/contributing/architecture.md"
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if match := INCLUDE.match(line):
                yield from ((path, number, reason) for reason in judged(module, modules, match[1] == '"', match[2]))


def judged(module, modules, quoted, header):
    """Why a file of that module may not include that header; nothing if it may."""
    if header.startswith("labmouse/"):
        other = header.split("/")[1]
        if other != module and other not in modules[module]:
            yield f"{module} must not include {other}: {header}"
    elif quoted and module != "apps":
        yield f'{header} is not named by its path from the root: "labmouse/..."'
    elif ".." in header:
        yield f"{header} climbs out of its folder"
    elif module in PORTABLE_MODULES and header in BANNED_HEADERS:
        yield f"{module} must not include <{header}>"


def package_of(header):
    """`lab/text` of `labmouse/lab/text/counted.hpp`; of a file that lies in its module directly, the module."""
    return "/".join(header.split("/")[1:-1][:2])


def package_violations(root, packages):
    """Each package includes just those that the table names, and a module with a list of all its packages has no other files."""
    modules = {name.split("/")[0] for name in packages}
    used, files = {name: set() for name in packages}, {name: 0 for name in packages}
    for path in library(root):
        package = package_of(name_of(path, root))
        if package.split("/")[0] not in modules or (package not in packages and package == "mouse"):
            continue
        if package not in packages:
            yield path, 1, f"{package} is no package of docs/contributing/architecture.md"
            continue
        files[package] += 1
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            match = INCLUDE.match(line)
            other = package_of(match[2]) if match and match[2].startswith("labmouse/") else package
            if other == package or other not in packages or other.split("/")[0] != package.split("/")[0]:
                continue
            used[package].add(other)
            if other not in packages[package]:
                yield path, number, f"{package} must not include {other}: {match[2]}"
    page = root / "docs/contributing/architecture.md"
    for package, allowed in packages.items():
        if unused := sorted(allowed - used[package]):
            yield page, 1, f"{package} does not include {', '.join(unused)}, though the table says so"
        if files[package] == 0:
            yield page, 1, f"{package} has no files"
        if files[package] > MOST_FILES_IN_A_PACKAGE:
            yield page, 1, f"{package} has {files[package]} files; {MOST_FILES_IN_A_PACKAGE} are the most"


def serves_all_worlds(name):
    """Whether a file's path is not that of one that is about some worlds."""
    parts = name.split("/")
    if name in NAME_A_WORLD or (parts[:2] == ["apps", "cli"] and Path(name).stem in COMMANDS_ABOUT_WORLDS):
        return False
    if name.endswith("core/types.ts"):
        return False  # written by the core
    return parts[0] == "apps" or parts[2] not in ABOUT_WORLDS


def names_of_worlds(line):
    """The names of worlds in the texts of a line of code; commands to type are none."""
    code = line.split("//")[0]
    for text in (match[1] or match[2] or match[3] or "" for match in TEXT.finditer(code)):
        found = WORLD_NAME.search(text)
        if found and not EXAMPLE.search(text):
            yield next(name for name in found.groups() if name)
    for found in WORLD_VALUE.finditer(code):
        if found[1] in ("steps", "seconds"):  # the others are names wherever they stand
            yield found[1]


def world_violations(root):
    """Library, command line, Python and page serve all worlds: they include none and say none's name."""
    paths = [*library(root, "lab"), *library(root, "external"), *sources(root / "apps"),
             *sorted((root / "apps/python/labmouse").rglob("*.py")), *sorted((root / "apps/web/page/src").rglob("*.ts*"))]
    for path in paths:
        if not serves_all_worlds(name_of(path, root)):
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            match = INCLUDE.match(line)
            if match and package_of(match[2]) in {f"lab/{package}" for package in WORLD_PACKAGES}:
                yield path, number, f"what serves all worlds must not include {match[2]}"
            for name in names_of_worlds(line) if not match else ():
                yield path, number, f"what serves all worlds must not name that of {name}"


def cycle_violations(root):
    """No file needs itself: X.hpp and X.cpp are one, and includes lead from it to no other that leads back."""
    includes = {}
    for path in library(root):
        unit = Path(name_of(path, root)).with_suffix("").as_posix()
        found = includes.setdefault(unit, set())
        for line in path.read_text(encoding="utf-8").splitlines():
            if match := INCLUDE.match(line):
                found.add(re.sub(r"\.hpp$", "", match[2]))
    done = set()

    def search(unit, way):
        if unit in way:
            return way[way.index(unit):] + [unit]
        if unit in done:
            return None
        for other in sorted(includes.get(unit, set()) - {unit}):
            if cycle := search(other, way + [unit]):
                return cycle
        done.add(unit)
        return None

    for unit in sorted(includes):
        if cycle := search(unit, []):
            yield root / cycle[0], 1, f"includes itself: {' -> '.join(cycle)}"
            return


def system_violations(root):
    """What a build without external mice compiles includes no header of one system, itself or through others of ours."""
    external = re.search(r'set\(LABMOUSE_LEFT_OUT "([^"]*/external/[^"]*)"\)', (root / "CMakeLists.txt").read_text(encoding="utf-8"))
    left_out = re.compile(external[1]) if external else None
    reached = set()
    todo = [path for path in library(root) + sources(root / "apps") if path.suffix == ".cpp"
            and not (left_out and left_out.search(f"/{path.relative_to(root).as_posix()}"))]
    while todo:
        path = todo.pop()
        name = path.relative_to(root).as_posix()
        if path in reached or name in SYSTEM_FILES or not path.exists():
            continue
        reached.add(path)
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            match = INCLUDE.match(line)
            if match and match[1] == '"':
                todo += [root / match[2], root / "include" / match[2], path.parent / match[2]]
            elif match and SYSTEM_HEADER.match(match[2]):
                yield path, number, f"<{match[2]}> is of one system; {SYSTEM_FILES[0]} is for such calls"


def number_violations(root):
    """One file reads numbers, and no number is written or read as the locale has it."""
    for path in library(root) + sources(root / "apps"):
        if path.relative_to(root).as_posix() == NUMBER_FILE:
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            code, include = line.split("//")[0], INCLUDE.match(line)
            if include and include[2] in STREAM_HEADERS:
                yield path, number, f"<{include[2]}> writes numbers as the locale has them; fmt::format does not"
            elif match := NUMBER_WRITER.search(code):
                yield path, number, f"{match[1]} writes numbers as the locale has them; fmt::format does not"
            elif match := NUMBER_READER.search(code) or NUMBER_STREAM.search(code):
                yield path, number, f"{match[1]} reads a number; {NUMBER_FILE} is for that"


def static_violations(root):
    """The portable modules have no variables outside of functions and objects but those that the compiler has fixed."""
    for module in PORTABLE_MODULES:
        for path in library(root, module):
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                code = line.split("//")[0]
                if re.search(r"\bthread_local\b", code) or STATIC.match(code) or GLOBAL.match(code):
                    yield path, number, f"{module} has no variables that last: constexpr, constinit const, or a member"


def link_violations(root, modules):
    """labmouse_module(NAME MODULE...) links what the table allows: no less, so that the table is not wider than it has to be."""
    path = root / "CMakeLists.txt"
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if match := re.match(r"\s*labmouse_module\((\w+)([\w\s]*)\)", line):
            name, linked = match[1], set(match[2].split())
            if linked != modules.get(name):
                wanted = " ".join(sorted(modules[name])) if name in modules else "no such module"
                yield path, number, f"{name} links {' '.join(sorted(linked))}, but docs/contributing/architecture.md says: {wanted}"


def public_header_violations(root):
    """In include/ are the headers that docs/how-to/use-the-library.md describes, and what these include: no more, no less."""
    page = root / "docs/how-to/use-the-library.md"
    described = re.findall(r"^\| `(labmouse/[\w/]+\.hpp)` \|", page.read_text(encoding="utf-8"), re.MULTILINE) if page.exists() else []
    for header in described:
        if not (root / "include" / header).exists():
            yield page, 1, f"include/{header} is described, and not there"
    needed, todo = set(), list(described)
    while todo:
        header = todo.pop()
        path = root / "include" / header
        if header in needed or not path.exists():
            continue
        needed.add(header)
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            match = INCLUDE.match(line)
            if match and match[2].startswith("labmouse/"):
                todo.append(match[2])
                if not (root / "include" / match[2]).exists():
                    yield path, number, f"is installed, and includes {match[2]}, which is not: that must lie in include/, too"
    for path in sources(root / "include"):
        if name_of(path, root) not in needed:
            yield path, 1, f"is installed, but {page.relative_to(root)} does not describe it, nor is it included by what it describes"


def builtin_mice_violations(root):
    """Every BuiltinMouse that a strategy's file defines is in the list of built-in mice."""
    builtin_mice = root / "labmouse/strategies/builtin_mice.cpp"
    if not builtin_mice.exists():
        return
    listed = set(re.findall(r"&(\w+_mouse)\b", builtin_mice.read_text(encoding="utf-8")))
    for path in sources(builtin_mice.parent):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            match = re.match(r"\s*(?:constinit )?const BuiltinMouse (\w+_mouse)\b", line)
            if match and match[1] not in listed:
                yield path, number, f"{match[1]} is not in the list of built-in mice"


def violations(root):
    """All violations as lines of text."""
    root = Path(root)
    page = (root / "docs/contributing/architecture.md").read_text(encoding="utf-8")
    modules, packages = modules_of(page), packages_of(page)
    found = [*include_violations(root, modules), *package_violations(root, packages), *world_violations(root),
             *cycle_violations(root), *static_violations(root), *system_violations(root), *number_violations(root), *link_violations(root, modules),
             *builtin_mice_violations(root), *public_header_violations(root)]
    return [f"{path.relative_to(root)}:{number}: error: {reason}" for path, number, reason in found]


if __name__ == "__main__":
    lines = violations(sys.argv[1])
    for line in lines:
        print(line)
    sys.exit(1 if lines else 0)
