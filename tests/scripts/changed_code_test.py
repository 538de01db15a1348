"""scripts/changed_code.py tells comments from code.

usage: changed_code_test.py ROOT
"""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(sys.argv.pop(1)) / "scripts"))
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


unittest.main()
