"""The tree keeps to docs/contributing/architecture.md, and small trees that do not are found out."""
import tempfile
import unittest
from pathlib import Path

from architecture import modules_of, violations

ROOT = Path(__file__).resolve().parents[2]

PAGE = """
| module | holds | may include | must not touch |
|---|---|---|---|
| grid | cells | nothing | heap |
| maze | truth | grid | mouse |
| mouse | log-odds map | grid | maze |
| strategies | strategies | grid, mouse | maze |
| lab | many runs | all above | terminals |
| apps | programs | all above | logic |
"""

PACKAGES = """
| package | holds | includes |
|---|---|---|
| lab/text | words | nothing |
| lab/races | many contests | text |
"""


def violations_of(files, page=PAGE):
    """What is found in a tree of these files, {path: text}."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in {"docs/contributing/architecture.md": page, "CMakeLists.txt": "", **files}.items():
            path = Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        return violations(folder)


class Architecture(unittest.TestCase):
    def test_this_tree_keeps_to_the_page(self):
        self.assertEqual(violations(ROOT), [])

    def test_the_page_lists_every_module_and_no_other(self):
        folders = {path.name for library in ("include/labmouse", "labmouse") for path in (ROOT / library).iterdir() if path.is_dir()}
        self.assertEqual(set(modules_of((ROOT / "docs/contributing/architecture.md").read_text(encoding="utf-8"))), folders | {"apps"})

    def test_what_the_table_allows_is_no_violation(self):
        self.assertEqual(violations_of({
            "labmouse/maze/maze.hpp": '#include <vector>\n#include "labmouse/grid/cell.hpp"\n',
            "labmouse/maze/maze.cpp": '#include "labmouse/maze/maze.hpp"\n',
            "labmouse/lab/race.cpp": '#include <thread>\n#include "labmouse/mouse/strategy.hpp"\n',
            "apps/cli/main.cpp": '#include <fstream>\n#include "command.hpp"\n#include "labmouse/lab/race.hpp"\n',
            "CMakeLists.txt": "labmouse_module(maze grid)\n",
        }), [])

    def test_a_strategy_that_includes_a_maze(self):
        self.assertEqual(violations_of({"labmouse/strategies/cheat.cpp": '\n#include "labmouse/maze/maze.hpp"\n'}),
                         ["labmouse/strategies/cheat.cpp:2: error: strategies must not include maze: "
                          "labmouse/maze/maze.hpp"])

    def test_a_module_that_includes_one_below_it(self):
        self.assertEqual(violations_of({"labmouse/grid/cell.hpp": '#  include "labmouse/lab/race.hpp"\n'}),
                         ["labmouse/grid/cell.hpp:1: error: grid must not include lab: labmouse/lab/race.hpp"])

    def test_a_module_that_the_page_does_not_know(self):
        self.assertEqual(violations_of({"labmouse/attic/box.hpp": ""}),
                         ["labmouse/attic/box.hpp:1: error: attic is no module of docs/contributing/architecture.md"])

    def test_an_include_that_hides_its_module(self):
        self.assertEqual(violations_of({"labmouse/mouse/route.cpp": '#include "../maze/maze.hpp"\n'}),
                         ['labmouse/mouse/route.cpp:1: error: ../maze/maze.hpp is not named by its path from the root: '
                          '"labmouse/..."'])

    def test_a_program_that_climbs_into_the_library(self):
        self.assertEqual(violations_of({"apps/cli/main.cpp": '#include "../../labmouse/lab/race.hpp"\n'}),
                         ["apps/cli/main.cpp:1: error: ../../labmouse/lab/race.hpp climbs out of its folder"])

    def test_a_portable_module_that_throws_the_library_s_dice(self):
        self.assertEqual(violations_of({"labmouse/maze/prim.cpp": "#include <random>\n"}),
                         ["labmouse/maze/prim.cpp:1: error: maze must not include <random>"])

    def test_a_link_that_the_page_does_not_allow(self):
        self.assertEqual(violations_of({"CMakeLists.txt": "labmouse_module(mouse grid maze)\n"}),
                         ["CMakeLists.txt:1: error: mouse links grid maze, but docs/contributing/architecture.md says: grid"])

    def test_a_strategy_that_is_not_in_the_list_of_built_in_mice(self):
        self.assertEqual(violations_of({
            "labmouse/strategies/builtin_mice.cpp": "constexpr std::array entries = {&flood_mouse};\n",
            "labmouse/strategies/flood.cpp": "constinit const BuiltinMouse flood_mouse = {};\n",
            "labmouse/strategies/shy.cpp": "constinit const BuiltinMouse shy_mouse = {};\n",
        }), ["labmouse/strategies/shy.cpp:1: error: shy_mouse is not in the list of built-in mice"])

    def test_packages_that_keep_to_the_page(self):
        self.assertEqual(violations_of({
            "labmouse/lab/text/words.hpp": "",
            "labmouse/lab/races/race.cpp": '#include "labmouse/lab/text/words.hpp"\n',
        }, PAGE + PACKAGES), [])

    def test_a_package_that_includes_one_below_it(self):
        found = violations_of({
            "labmouse/lab/text/words.cpp": '#include "labmouse/lab/races/race.hpp"\n',
            "labmouse/lab/races/race.hpp": '#include "labmouse/lab/text/other.hpp"\n',
        }, PAGE + PACKAGES)
        self.assertEqual(found, ["labmouse/lab/text/words.cpp:1: error: lab/text must not include lab/races: "
                                 "labmouse/lab/races/race.hpp"])

    def test_a_file_outside_of_all_packages(self):
        self.assertIn("labmouse/lab/odd.hpp:1: error: lab is no package of docs/contributing/architecture.md",
                      violations_of({"labmouse/lab/odd.hpp": ""}, PAGE + PACKAGES))

    def test_a_table_of_packages_that_is_wider_than_it_has_to_be(self):
        found = violations_of({"labmouse/lab/text/words.hpp": "", "labmouse/lab/races/race.hpp": ""}, PAGE + PACKAGES)
        self.assertEqual(found, ["docs/contributing/architecture.md:1: error: lab/races does not include lab/text, though the table says so"])

    def test_a_package_that_has_become_a_module_of_its_own(self):
        files = {f"labmouse/lab/text/words{number}.hpp": "" for number in range(41)}
        files["labmouse/lab/races/race.hpp"] = '#include "labmouse/lab/text/words1.hpp"\n'
        self.assertEqual(violations_of(files, PAGE + PACKAGES),
                         ["docs/contributing/architecture.md:1: error: lab/text has 41 files; 40 are the most"])

    def test_what_serves_all_worlds_and_names_one(self):
        self.assertEqual(violations_of({
            "labmouse/lab/races/race.cpp": 'if (world.name() == "mms") return;\n',
            "labmouse/lab/store/store.cpp": 'if (world.name() == "failures") return;\n',
            "labmouse/lab/page/about.cpp": 'if (world.name() == "failures") return;\n',
            "labmouse/lab/page/open.cpp": 'return "only in the physical world";\n',
            "apps/cli/race.cpp": '#include "labmouse/lab/drive/seconds_world.hpp"\n',
            "apps/cli/sweep.cpp": 'fail("name the world mms");\n',
            "apps/cli/replay.cpp": 'option("In physical: saves the log");\n',
            "apps/web/page/src/race/chart.ts": "const unit = 'seconds';\nconst race = { world: 'seconds' };\nplay['world'] === `steps`;\n",
            "apps/web/page/src/race/form.tsx": "tell(`only in the physical world`);\n",
            "apps/python/race.cpp": 'held("waited for some seconds", "world seconds");\n',
            "labmouse/lab/worlds/list.cpp": '#include "labmouse/lab/steps/steps_entry.hpp"\n',
            "apps/cli/robot.cpp": '#include "labmouse/lab/steps/steps_world.hpp"\n',
            "apps/cli/tune.cpp": 'footer("Example: labmouse tune festina --world failures");  // the failure model\n',
        }), ["labmouse/lab/page/open.cpp:1: error: what serves all worlds must not name that of physical",
             "labmouse/lab/races/race.cpp:1: error: what serves all worlds must not name that of mms",
             "labmouse/lab/store/store.cpp:1: error: what serves all worlds must not name that of failures",
             "apps/cli/race.cpp:1: error: what serves all worlds must not include "
             "labmouse/lab/drive/seconds_world.hpp",
             "apps/cli/replay.cpp:1: error: what serves all worlds must not name that of physical",
             "apps/cli/sweep.cpp:1: error: what serves all worlds must not name that of mms",
             "apps/python/race.cpp:1: error: what serves all worlds must not name that of seconds",
             "apps/web/page/src/race/chart.ts:2: error: what serves all worlds must not name that of seconds",
             "apps/web/page/src/race/chart.ts:3: error: what serves all worlds must not name that of steps",
             "apps/web/page/src/race/form.tsx:1: error: what serves all worlds must not name that of physical"])

    def test_files_that_need_each_other(self):
        self.assertEqual(violations_of({
            "labmouse/maze/a.cpp": '#include "labmouse/maze/a.hpp"\n#include "labmouse/maze/b.hpp"\n',
            "labmouse/maze/b.cpp": '#include "labmouse/maze/a.hpp"\n',
        }), ["labmouse/maze/a:1: error: includes itself: labmouse/maze/a -> labmouse/maze/b -> labmouse/maze/a"])

    def test_what_only_one_system_has(self):
        files = {
            "labmouse/lab/system/calls.cpp": "#include <unistd.h>\n",
            "labmouse/lab/kept.cpp": "#include <csignal>\n#include <sys.h>\n",
            "labmouse/lab/race.cpp": "#include <sys/stat.h>\n",
            "labmouse/maze/keeper.cpp": '#include <poll.h>\n#include "labmouse/maze/keeper.hpp"\n',
            "labmouse/maze/keeper.hpp": "#include <unistd.h>\n",
            "CMakeLists.txt": 'set(LABMOUSE_LEFT_OUT "/external/.*|/maze/(keeper)[.]cpp$")\n',
        }
        reason = "is of one system; labmouse/lab/system/calls.cpp is for such calls"
        self.assertEqual(violations_of(files), [f"labmouse/lab/race.cpp:1: error: <sys/stat.h> {reason}"])
        files["labmouse/lab/race.cpp"] = '#include "labmouse/maze/keeper.hpp"\n'
        self.assertEqual(violations_of(files), [f"labmouse/maze/keeper.hpp:1: error: <unistd.h> {reason}"])

    def test_numbers_that_are_read_elsewhere(self):
        for line, reader in (("const double x = std::strtod(text, &end);", "strtod"), ("int x = std::stoi(text);", "stoi"),
                             ("auto x = std::stoull(text);", "stoull"), ("x = atof(text);", "atof"),
                             ("std::from_chars(begin, end, x);", "from_chars"), ("sscanf(text, \"%d\", &x);", "sscanf"),
                             ('std::ifstream("/proc/loadavg") >> load;', "ifstream")):
            for path in ("labmouse/maze/a.cpp", "apps/cli/a.cpp"):
                with self.subTest(line, path=path):
                    self.assertEqual(violations_of({path: f"\n  {line}\n"}), [
                        f"{path}:2: error: {reader} reads a number; labmouse/functions/parse_number.hpp is for that"])

    def test_numbers_that_are_written_as_the_locale_has_them(self):
        for line, writer in (('std::snprintf(text, 9, "%-4.2f", x);', "snprintf"), ('std::printf("%s %g", name, x);', "printf"),
                             ("#include <sstream>", "<sstream>"), ("#include <iomanip>", "<iomanip>")):
            with self.subTest(line):
                self.assertEqual(violations_of({"apps/cli/a.cpp": f"\n{line}\n"}), [
                    f"apps/cli/a.cpp:2: error: {writer} writes numbers as the locale has them; fmt::format does not"])

    def test_what_reads_and_writes_no_such_numbers(self):
        for line in ("// std::stoi would take +1", 'store(text);', 'std::printf("%d%%", x);', "std::getline(stream, text);",
                     'std::fputs("%f", stdout);', "const auto restored = world.stored(x >> 3);"):
            with self.subTest(line):
                self.assertEqual(violations_of({"labmouse/lab/a.cpp": f"\n{line}\n"}), [])
        self.assertEqual(violations_of({"labmouse/functions/parse_number.hpp": "std::from_chars(begin, end, x);\n"},
                                       PAGE + "| functions | numbers | nothing | heap |\n"), [])

    def test_variables_that_last(self):
        for line in ("static int calls = 0;", "  static const std::vector<int> table = [] {", "  static Knowledge known;",
                     "  static std::vector<int> table(100);", "  static std::vector<int> table(size);",
                     "inline static int calls;", "thread_local int depth = 0;", "std::atomic<int> calls{0};",
                     "const std::string name = \"flood\";", "int calls;", "extern int calls;", "int table[3] = {",
                     "const std::vector<std::pair<int, int>> list ="):
            with self.subTest(line):
                self.assertEqual(violations_of({"labmouse/mouse/a.cpp": f"\n{line}\n"}),
                                 ["labmouse/mouse/a.cpp:2: error: mouse has no variables that last: "
                                  "constexpr, constinit const, or a member"])

    def test_what_is_no_variable_that_lasts(self):
        for line in ("  static constexpr std::array deep = [] {", "constinit const Format maz_format = {",
                     "inline constexpr int no_place = -1;", "extern const BuiltinMouse flood_mouse;", "  int calls = 0;",
                     "  static int leap(int node, unsigned bit) const;", "  static bool never(const Settings&) { return 0; }",
                     "static int twice(int) {", "using Motion = int;", "struct Cell {", "enum class Run : std::uint8_t {",
                     "template class Lattice<int>;", "Lattice<Word>::Lattice(Size size) : size_{size} {",
                     "// static int calls = 0;", "int twice(int number) {", "namespace labmouse {"):
            with self.subTest(line):
                self.assertEqual(violations_of({"labmouse/mouse/a.cpp": f"\n{line}\n"}), [])

    def test_the_lab_may_have_variables_that_last(self):
        self.assertEqual(violations_of({"labmouse/lab/a.cpp": "static int calls = 0;\n"}), [])

    def test_installed_headers_and_their_page(self):
        page = "docs/how-to/use-the-library.md"
        found = violations_of({
            "include/labmouse/grid/cell.hpp": '#include "labmouse/grid/size.hpp"\n#include "labmouse/grid/bits.hpp"\n',
            "include/labmouse/grid/size.hpp": "",
            "include/labmouse/grid/wall.hpp": "",
            "labmouse/grid/bits.hpp": "",
            page: "| `labmouse/grid/cell.hpp` | cells |\n| `labmouse/grid/set.hpp` | sets |\n",
        })
        self.assertEqual(found, [
            f"{page}:1: error: include/labmouse/grid/set.hpp is described, and not there",
            "include/labmouse/grid/cell.hpp:2: error: is installed, and includes labmouse/grid/bits.hpp, which is not: that must lie "
            "in include/, too",
            f"include/labmouse/grid/wall.hpp:1: error: is installed, but {page} does not describe it, nor is it included by what it "
            "describes"])

    def test_a_header_in_include_belongs_to_its_module(self):
        found = violations_of({"include/labmouse/grid/cell.hpp": '#include "labmouse/lab/race.hpp"\n'})
        self.assertIn("include/labmouse/grid/cell.hpp:1: error: grid must not include lab: labmouse/lab/race.hpp", found)

    def test_a_table_out_of_order(self):
        with self.assertRaisesRegex(ValueError, "module grid may include maze, which the table does not list above it"):
            violations_of({}, "| grid | cells | maze | heap |\n| maze | truth | grid | mouse |\n")

    def test_a_page_without_a_table(self):
        with self.assertRaisesRegex(ValueError, "no table of modules"):
            violations_of({}, "# Architecture\n")


if __name__ == "__main__":
    unittest.main()
