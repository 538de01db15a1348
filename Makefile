# The two commands. They install what is missing, build what has changed, say how far that is, and show what the compiler
# said only if it fails.
#   make race    races the mice on the built-in mazes and prints the leaderboard
#   make check   builds and runs all tests
# The page, in a browser:
#   make page    builds build/page/labmouse.html, without the program; the next build of the program takes it in
# The documentation:
#   make docs    builds the site in build/docs; the live demo is in it if the page was built before
# The libraries for chips:
#   make firmware writes their archives to build/firmware
# The Python package:
#   make wheel   builds a wheel, and the sources to install from, in build/dist
# Debian packages:
#   make deb     builds labmouse, labmouse-page and liblabmouse-dev in build/deb
# And, when a mouse has changed:
#   make reports runs every system of the five reports and writes docs/research/reports.md
# And, before a release:
#   make proof   the checks that take too long for .ci/run: docs/contributing/checks.md
# One build tree, build/release, serves both: a race builds the program alone, so that it never waits for tests.
.PHONY: race check page docs firmware wheel deb reports proof

# Configured once: from then on the build does it by itself, where it has to.
race:
	@scripts/install race
	@test -e build/release/build.ninja || scripts/quietly cmake --preset release
	@test -e build/release/labmouse || echo "building labmouse; this takes about 4 minutes of processor time" >&2
	@scripts/quietly --log build/release/build.log cmake --build --preset release --target labmouse
	@build/release/labmouse race

# More options for CMake, and so for both commands until the next check.
CHECK_OPTIONS ?=

check:
	@scripts/install check
	@scripts/page --if-installed
	@scripts/quietly cmake --preset release -DLABMOUSE_TESTS=ON $(CHECK_OPTIONS)
	@test -e build/release/tests/lab_test || echo "building the tests, and labmouse if it is missing; this takes about 6 minutes of processor time, and 4 more for labmouse" >&2
	@scripts/quietly --log build/release/build.log cmake --build --preset release
	@scripts/run-tests release

page:
	@scripts/install page
	@scripts/page
	@echo "build/page/labmouse.html"

docs:
	@scripts/install docs
	@echo "building the documentation; this takes about a minute of processor time" >&2
	@scripts/quietly scripts/docs
	@echo "build/docs/index.html"

firmware:
	@scripts/firmware --archives

wheel:
	@scripts/install race
	@scripts/install python
	@scripts/page --if-installed
	@scripts/wheel --sdist

deb:
	@scripts/install race
	@test -e build/page/labmouse.html || $(MAKE) --no-print-directory page
	@echo "building the packages; this takes about 8 minutes of processor time" >&2
	@scripts/deb

reports:
	@scripts/install race
	@test -e build/release/build.ninja || scripts/quietly cmake --preset release
	@scripts/quietly cmake --build --preset release --target labmouse
	@scripts/reports

proof:
	@scripts/proof
