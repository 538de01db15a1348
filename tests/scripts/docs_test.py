"""scripts/docs: links as they are in the site, the navigation, and what is found in a site that is not whole.

usage: docs_test.py ROOT
"""

import importlib.machinery
import importlib.util
import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv.pop(1))
loader = importlib.machinery.SourceFileLoader("docs", str(ROOT / "scripts" / "docs"))
docs = importlib.util.module_from_spec(importlib.util.spec_from_loader("docs", loader))
loader.exec_module(docs)


class Docs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name).resolve()

    def in_the_site(self, text):
        (self.folder / "robots").mkdir()
        return docs.with_links_of_the_site(self.folder, "docs/how-to/a.md", text)

    def test_links_between_pages_stay(self):
        text = "[b](b.md#c) [c](../reference/c.md) [d](#d) [e](https://example.org) `[f](../../f.md)`"
        self.assertEqual(self.in_the_site(text), (text, ["docs/how-to/b.md", "docs/reference/c.md"]))

    def test_links_out_of_docs_lead_to_copies(self):
        self.assertEqual(self.in_the_site("[`a`](../../a.py) [b](../../b.md#c) [home](../README.md)"),
                         ("[`a`](../files/a.py) [b](../pages/b.md#c) [home](../index.md)", ["a.py", "b.md", "docs/README.md"]))

    def test_links_to_folders_become_text(self):
        self.assertEqual(self.in_the_site("[`robots/`](../../robots), [them](../../robots)"), ("`robots/`, them (`robots`)", []))

    def test_the_navigation_is_the_list_of_the_manual(self):
        self.assertEqual(docs.navigation_of("# M\n\n**How to**: [a](how-to/a.md) ·\n[b](how-to/b.md)\n\n**Research** (old): [c](c.md)\n"),
                         [("How to", ["how-to/a", "how-to/b"]), ("Research", ["c"])])

    def problems_of(self, page):
        (self.folder / "a.html").write_text(page, encoding="utf-8")
        return list(docs.problems_of(self.folder))

    def test_a_whole_site_has_no_problem(self):
        self.assertEqual(self.problems_of('<h1 id="b">B</h1><a href="a.html#b">b</a><a href="#b">b</a><a href="https://example.org">e</a>'), [])

    def test_dead_links_and_what_needs_the_network_are_found(self):
        for page in ('<a href="b.html">b</a>', '<a href="#b">b</a>', '<img src="b.png">', '<script src="https://example.org/a.js"></script>',
                     '<link rel="stylesheet" href="//example.org/a.css">'):
            self.assertEqual(len(self.problems_of(page)), 1, page)

    def test_fonts_from_the_network_are_found(self):
        (self.folder / "a.css").write_text("@font-face { src: url('https://example.org/a.woff2') }", encoding="utf-8")
        self.assertEqual(len(self.problems_of("")), 1)


if __name__ == "__main__":
    unittest.main()
