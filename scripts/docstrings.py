"""Finds the public types and functions of a C++ or C header that lack a docstring, and docstrings that do not describe parameters.

Public is what is declared outside of `private:` and the bodies of functions, pointers to functions among it. A docstring is a
comment of `///` or `/** */` directly above.
- The docstring of a function describes each parameter that has a name by @param. Operators do without: their operands are plain.
- What a function returns may be said by @return, or by its sentence: "The number of cells."
- Overloads directly below each other share the docstring of the first.
- Destructors, constructors that copy or move, overrides, comparisons, and what is `= default` or `= delete` need none.
"""

import re

TOKEN = re.compile(r"""(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<directive>^[ \t]*\#(?:[^\n]*\\\n)*[^\n]*)
                       |(?P<text>"(?:\\.|[^"\\\n])*"|(?<![\w])'(?:\\.|[^'\\\n])+')|(?P<space>\s+)|(?P<code>[\w]+|.)""",
                   re.VERBOSE | re.DOTALL | re.MULTILINE)
NO_FUNCTION = re.compile(r"(?:using|typedef|static_assert|friend (?:class|struct)|return)\b")
SCOPE = re.compile(r"\b(namespace|extern TEXT|class|struct|union)\b")
TYPE = re.compile(r"(?:enum (?:class |struct )?|class |struct |union )(?:alignas\([^)]*\) )?(\w+)")


def without_templates(head):
    """The head without `template <...>`, and without macros that stand alone."""
    if match := re.match(r"template\s*<", head):
        depth, place = 1, match.end()
        while depth and place < len(head):
            depth += {"<": 1, ">": -1}.get(head[place], 0)
            place += 1
        return without_templates(head[place:].lstrip())
    return re.sub(r"^[A-Z][A-Z_]+ ?\([^()]*\) ?", "", head)


def function_of(head):
    """The name of the function that is declared, and its parameters as text; nothing if it is another declaration."""
    head = re.sub(r"\s+", " ", without_templates(head.strip()))
    head = re.sub(r"^(?:\[\[\w+\]\] )?(?:explicit ?\([^()]*\) )?", "", head)
    match = re.search(r"(\boperator ?(?:\( ?\)|[^\w\s(]+|\w[^(]*)|~ ?\w+|\( ?\* ?\w+ ?\)|\w+) ?\((?! ?\* ?\w+ ?\) ?\()", head)
    if not match or NO_FUNCTION.match(head):
        return None
    result = head[:match.start(1)]
    if result.count("<") > result.count(">") or "=" in result:
        return None  # the parentheses are those of a type, or of a value
    depth, place = 1, match.end()
    while depth and place < len(head):
        depth += {"(": 1, ")": -1}.get(head[place], 0)
        place += 1
    return match[1].strip("(*) "), head[match.end():place - 1].strip(), head[place:]


def names_of(parameters):
    """The names in a list of parameters; those that have none are left out."""
    while (plain := re.sub(r"<[^<>]*>|\([^()]*\)", "", parameters)) != parameters:
        parameters = plain
    found = (re.search(r"[\w>&*] ?\b(\w+)(?:\[\w*\])?$", re.sub(r"=.*", "", part).strip()) for part in parameters.split(","))
    return [match[1] for match in found if match]


def problem_of(function, docstring):
    """What the docstring of a function lacks; nothing if it is complete."""
    name, parameters, rest = function
    copies = re.fullmatch(rf"(?:const )?{re.escape(name)} ?&&?", parameters)
    inherited = re.search(r"\b(?:override|final)\b|= ?(?:default|delete)\b", rest)
    if copies or inherited or re.match(r"~|operator ?(?:==|!=|<=>|<$)", name):
        return None
    if not docstring.strip("/*! \n"):
        return f"{name} has no docstring"
    described = re.findall(r"@param (\w+)", docstring)
    lost = [parameter for parameter in names_of(parameters) if parameter not in described]
    if lost and not name.startswith("operator"):
        return f"the docstring of {name} has no @param {lost[0]}"
    return None


def problems_of(text):
    """[(line number, problem)] of a header."""
    found, depth = [], 0  # depth: of parentheses
    scopes = [True]  # of each scope whether what it declares is public; None for the body of a function, an enum and values
    head, begin, docstring, end_of_docstring = "", 0, "", 0
    before = ("", 0, None)  # name, last line and problem of the function before

    def attached():
        return docstring if end_of_docstring + 1 == begin else ""

    def ends(line):
        nonlocal before
        function = function_of(head) if scopes[-1] else None
        if function:
            shared = not attached() and before[:2] == (function[0], begin - 1)
            problem = before[2] if shared else problem_of(function, attached())
            if problem and not shared:
                found.append((begin, problem))
            before = (function[0], line, problem)
        return function

    line = 1
    for token in TOKEN.finditer(text):
        kind, word = token.lastgroup, token[0]
        if kind == "comment" and not head:
            if word.startswith(("///", "/**")) and not word.startswith(("///<", "/**<")):
                docstring = f"{docstring}\n{word}" if end_of_docstring + 1 == line else word
                end_of_docstring = line + word.count("\n")
        elif kind == "space" or kind == "text" or kind == "code":
            if kind != "space" and not head:
                begin = line
            if depth == 0 and word == "{":
                if scopes[-1] and (kept := TYPE.match(without_templates(head))) and not attached():
                    found.append((begin, f"{kept[1]} has no docstring"))
                if scopes[-1] is None:
                    scopes.append(None)
                elif (scope := SCOPE.search(head)) and "(" not in head and not re.match(r"enum\b", head):
                    scopes.append(scopes[-1] and scope[1] != "class")
                    head = ""
                else:
                    scopes.append(None)
            elif depth == 0 and word == "}":
                last = scopes.pop()
                if last is not None:
                    head = ""
                elif scopes[-1] is not None and ends(line):
                    head = ""
            elif scopes[-1] is not None:
                if depth == 0 and word == ";":
                    ends(line)
                    head = ""
                elif depth == 0 and word == ":" and head.strip() in ("public", "private", "protected"):
                    scopes[-1], head = scopes[-2] and head.strip() != "private", ""
                else:
                    depth += {"(": 1, ")": -1}.get(word, 0)
                    head += "TEXT" if kind == "text" else word if head or kind != "space" else ""
        line += word.count("\n")
    return found
