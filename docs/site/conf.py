"""Settings of Sphinx for the site. scripts/docs calls it, with its pages in build/docs-source."""

import inspect
import os
import re
import sys
from pathlib import Path

ROOT = Path(os.environ["LABMOUSE_ROOT"])
BUILD = ROOT / "build"
sys.path.insert(0, str(BUILD / "docs-python"))

project = "labmouse"
release = re.search(r"project\(labmouse VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.githubpages", "breathe"]
exclude_patterns = ["files/**"]

# Dashes, but quotation marks as they are typed in Python.
smartquotes_action = "D"
# Headings have the anchors that hosts of repositories give them.
myst_heading_anchors = 6

# What the package imports and the site does not need.
autodoc_mock_imports = ["cloudpickle", "distributed", "gymnasium", "matplotlib", "pandas", "scipy"]
autodoc_member_order = "bysource"
python_maximum_signature_line_length = 100
# Docstrings are plain text, in which `x` is code.
default_role = "code"

breathe_projects = {"labmouse": str(BUILD / "docs-doxygen" / "xml")}
breathe_default_project = "labmouse"
breathe_show_include = False
cpp_maximum_signature_line_length = 100

html_theme = "furo"
html_title = f"labmouse {release}"
html_static_path = ["site.css"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sphinx = False
html_show_copyright = False
# A page that is opened from disk cannot read the other pages, which the summaries need.
html_show_search_summary = False


def with_parameters(app, what, name, thing, options, lines):
    """Makes fields of the lines `parameter: what it is` in the docstring of a function, and of those below `Args:`."""
    if what not in ("class", "function", "method"):
        return
    found, inside, in_arguments = [], False, False
    for line in lines:
        if line == "Args:":
            in_arguments = True
            continue
        in_arguments = in_arguments and bool(line)
        line = line.removeprefix("    ") if in_arguments else line
        match = re.match(r"(\w+)(, \w+)*: ", line)
        if match and (in_arguments or what != "class" and match[1] in inspect.signature(thing).parameters):
            # In a field, two words would be a type and a name.
            field = f":param {match[0].replace(', ', '/')}{line[match.end():]}"
            found += [field] if inside else ["", field]
            inside = True
        else:
            inside = inside and bool(line)
            found.append(f"    {line}" if inside else line)
    lines[:] = found


def setup(app):
    app.connect("autodoc-process-docstring", with_parameters)
