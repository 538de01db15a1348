"""scripts/words finds what it is for, and tests/docs/run_examples.py writes examples as they are today.

usage: words_test.py ROOT
"""

import importlib.machinery
import importlib.util
import io
import pathlib
import sys
import tempfile
import unittest
from contextlib import redirect_stdout

ROOT = pathlib.Path(sys.argv.pop(1))


def loaded(path):
    loader = importlib.machinery.SourceFileLoader(path.stem, str(path))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(path.stem, loader))
    loader.exec_module(module)
    return module


class Words(unittest.TestCase):
    def said_of(self, page, header="// A header.\n", navigation="[a](reference/a.md)\n"):
        """The exit code and the lines about a tree with that page of the manual."""
        words = loaded(ROOT / "scripts" / "words")
        with tempfile.TemporaryDirectory() as name:
            words.ROOT = pathlib.Path(name).resolve()
            files = {"README.md": "# Mice\n", "docs/README.md": navigation, "docs/reference/a.md": page, "labmouse/a.hpp": header}
            for path, text in files.items():
                (words.ROOT / path).parent.mkdir(parents=True, exist_ok=True)
                (words.ROOT / path).write_text(text, encoding="utf-8")
            sys.argv = ["words"]
            with redirect_stdout(io.StringIO()) as out:
                code = words.main()
        return code, out.getvalue().splitlines()

    def test_plain_pages_pass(self):
        page = "# A\n\nIt runs. [Here](#a), [there](../../README.md), [out](https://example.org).\n\n```\na mind strays\n```\n"
        self.assertEqual(self.said_of(page)[0], 0)

    def test_what_is_wrong_is_found(self):
        for page in ("A mind explores.", "It is in a line\nup with the fallible world.", "word " * 36 + "end.",
                     "[lost](b.md)", "[lost](#b)", "# A\n\n[lost](../../README.md#rats)"):
            code, lines = self.said_of(page + "\n")
            self.assertEqual((code, len(lines)), (1, 2), page)
            self.assertIn("docs/reference/a.md", lines[0])

    def test_every_page_is_in_the_navigation(self):
        self.assertEqual(self.said_of("# A\n", navigation="[b](../README.md)\n")[0], 1)

    def test_headers_begin_with_a_sentence(self):
        self.assertEqual(self.said_of("# A\n", "#pragma once\n")[0], 1)

    def test_public_types_and_functions_have_docstrings(self):
        find = loaded(ROOT / "scripts" / "docstrings.py").problems_of
        for line in ("int f();", "// Plain.\nint f();", "/// Far.\n\nint f();", "/// One.\n/// @return a.\nint f(int a);", "int f() { return 1; }",
                     "/// A.\nstruct A {\n  /// One.\n  explicit A(int a) : a_{a} {}\n};", "/// A.\nclass A {\n public:\n  int f() const;\n};",
                     "template <class T, int n = 1>\nT f();", "/// One.\nint f();\nint g();", "int a = g();  ///< One.\nint f();",
                     "/// A.\nstruct A {\n  /** One. */\n  int (*f)(void* a);\n};", "#define F(a) a\nint f();", "namespace a {\nint f();\n}",
                     "/// A.\nstruct A {\n  B b{1};\n  int f();\n};", "/// One.\nint f(int a);\nint f(int a, int b);",
                     "/// A.\nstruct A {\n  A& operator|=(A other);\n};", "/// One.\n/// @param a one.\nvoid f(int a, const A& b) {}", "/// One.\nint f(int a = b);", "struct A {};",
                     "enum class A : int { a };", "template <class T>\nclass A final : B {};", "/// A.\nstruct A {\n  enum B { c };\n};"):
            self.assertEqual(len(find(line + "\n")), 1, line)
        for line in ("/// One.\nint f();", "/// One.\n/// @param a a number.\nvoid f(int a);", "/** One.\n * @param a one. */\nint f(int a);",
                     "/// A.\nclass A {\n  int f();\n};", "/// A.\nclass A {\n public:\n  A() = default;\n  ~A();\n private:\n  int f(int a);\n};",
                     "/// A.\nstruct A : B {\n  int f(int a) const override;\n  int g() final { return h(1); }\n};",
                     "friend bool operator==(A, A) = default;", "int a = g(1);", "int a{g(1)};", "std::function<int(int)> f;", "using F = int(int);",
                     "static_assert(sizeof(int) == 4);", "/// A.\nenum class A { a = int(1), b };", "/// A.\nstruct A {\n  int a = 1;\n  B b = {f(1)};\n};",
                     "/// One.\nint f() {\n  if (g(1)) return h(2);\n  return 3;\n}", "/// One.\n/// @param a one.\nint f(int a);\nint f(A a, int b);",
                     "/// One.\n/// @param a one.\n/// @param b one.\nint f(A<unsigned int, B> a = {1, 2}, B b = '(', int (*)(A c, A d) = g);", "#define F(a) \\\n  int f(a);", "const char* a = \"int f();\";",
                     "/// The sum.\nA operator+(A a, A b);", "/// A.\nstruct A {\n  A(A&&) noexcept;\n  A(const A& other);\n};",
                     "struct A;", "/// A.\nclass A {\n  struct B {};\n};", "/// A.\ntemplate <class T>\nclass A {};", "enum { a = 1 };",
                     "/// One.\nvoid f(int /*a*/, const A&) {}", "extern \"C\" {\n/// One.\nint f(void);\n}"):
            self.assertEqual(find(line + "\n"), [], line)

    def test_comments_and_messages_are_in_plain_words(self):
        for line in ("// A pilot.", "/* It was\n   held again. */", 'say("a guest ran");'):
            code, lines = self.said_of("# A\n", f"// A header.\nint x = 1;\n{line}\n")
            self.assertEqual((code, len(lines)), (1, 2), line)
            self.assertIn("labmouse/a.hpp:", lines[0])
        for line in ('read("guest");', "int pilot = 1;", "// As `pilot` has it.", 'say("labmouse pilot 1");'):
            self.assertEqual(self.said_of("# A\n", f"// A header.\n{line}\n")[0], 0, line)


class Examples(unittest.TestCase):
    def test_are_written_as_they_are_today(self):
        updated = loaded(ROOT / "tests" / "docs" / "run_examples.py").updated
        self.assertEqual(updated(["a 1", "b 2"], "a 1\nb 3\n"), ["a 1", "b 3"])
        self.assertEqual(updated(["a 1"], "a 1\nb 3\n"), ["a 1", "b 3"])
        self.assertEqual(updated(["head", "...", "tail"], "Head\nx\ny\nTail\n"), ["Head", "...", "Tail"])
        self.assertEqual(updated(["version..."], "version 2\n"), ["version..."])
        self.assertEqual(updated(["old 1..."], "new 22\n"), ["new 2..."])

    def test_are_written_into_their_page(self):
        examples = loaded(ROOT / "tests" / "docs" / "run_examples.py")
        page = "text\n\n```console\n$ one\n1\n$ two \\\n> more\n2\n```\n"
        with tempfile.TemporaryDirectory() as name:
            path = pathlib.Path(name) / "page.md"
            path.write_text(page, encoding="utf-8")
            found = examples.examples(page)
            examples.update(str(path), [(number, expected, f"new {i}\n") for i, (number, _, expected) in enumerate(found)])
            self.assertEqual(path.read_text(encoding="utf-8"), page.replace("\n1\n", "\nnew 0\n").replace("\n2\n", "\nnew 1\n"))


if __name__ == "__main__":
    unittest.main()
