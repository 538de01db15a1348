"""scripts/changed_code.py tells comments from code, and files that have changed from those that were moved.

usage: changed_code_test.py ROOT
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(sys.argv.pop(1)) / "scripts"))
import changed_code
from changed_code import code_of


class CodeOf(unittest.TestCase):
    def test_leaves_out_comments_and_layout(self):
        self.assertEqual(code_of("int a;  // one\n\n/* two\n lines */ int b;"), code_of("int a;\nint b;"))
        self.assertEqual(code_of("f(a,\n  b);"), code_of("f(a, b);"))

    def test_keeps_what_only_looks_like_a_comment(self):
        for one, other in [('"// a"', '"// b"'), ('R"(/* a */)"', 'R"(/* b */)"'), ("'/'", "'*'"), ('"  "', '" "'),
                           ('"a\\"//b"', '"a\\"//c"'), ("1'000 // a", "1'001 // a")]:
            self.assertNotEqual(code_of(one), code_of(other))

    def test_sees_other_code(self):
        self.assertNotEqual(code_of("int a; // b"), code_of("int b; // b"))
        self.assertNotEqual(code_of("#include <a>"), code_of("// #include <a>"))


class ChangedCode(unittest.TestCase):
    def test_a_moved_file_has_changed_only_with_its_code(self):
        with tempfile.TemporaryDirectory() as folder:
            changed_code.ROOT = root = pathlib.Path(folder)

            def git(*words):
                subprocess.run(["git", "-C", folder, "-c", "user.name=a", "-c", "user.email=a@b", *words], check=True, capture_output=True)

            git("init")
            (root / "old").mkdir()
            (root / "new").mkdir()
            code = "".join(f"int number_{i};\n" for i in range(20))
            for name in "abcd":
                (root / "old" / name).write_text(f"{code}int {name};\n")
            git("add", ".")
            git("commit", "-m", "All")
            for name in "abc":
                git("mv", f"old/{name}", "new")
            (root / "new/b").write_text(f"{code}\nint b;  // a comment\n")
            (root / "new/c").write_text(f"{code}int c = 1;\n")
            self.assertEqual(changed_code.changed_code("HEAD", "old", "new"), {"new/c"})
            self.assertIsNone(changed_code.changed_code("no-such-commit", "old"))


unittest.main()
