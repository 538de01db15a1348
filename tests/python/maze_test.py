"""Mazes as objects of Python."""

import pickle

import hypothesis.strategies as st
import labmouse
import numpy
import pytest
from hypothesis import given, settings

KINDS = ["depth-first", "prim", "kruskal", "wilson", "division", "contest"]
mazes = st.builds(
    labmouse.generate,
    kind=st.sampled_from([kind for kind in KINDS if kind != "contest"]),
    size=st.tuples(st.integers(2, 20), st.integers(2, 20)),
    seed=st.integers(0, 2**64 - 1),
    loops=st.floats(0, 1),
)


@given(mazes)
@settings(max_examples=50, deadline=None)
def test_a_maze_is_equal_to_what_its_arrays_text_and_pickle_give(maze):
    again = labmouse.Maze.from_walls(maze.north, maze.east, start=maze.start, heading=maze.heading, goals=maze.goals)
    for same in (again, labmouse.Maze.parse(maze.text()), pickle.loads(pickle.dumps(maze))):
        assert same == maze
        assert hash(same) == hash(maze)


@given(mazes, st.data())
@settings(max_examples=50, deadline=None)
def test_a_maze_with_one_wall_changed_is_another(maze, data):
    north = maze.north
    y = data.draw(st.integers(0, maze.height - 2))
    x = data.draw(st.integers(0, maze.width - 1))
    north[y, x] = not north[y, x]
    assert labmouse.Maze.from_walls(north, maze.east, goals=maze.goals) != maze
    assert maze.north[y, x] != north[y, x]  # each access returns a new array


def test_arrays_have_rows_from_the_south():
    maze = labmouse.Maze.parse("o---o---o---o\n|         G |\no   o---o   o\n| S |       |\no---o---o---o\n")
    assert maze.north.shape == maze.east.shape == (2, 3)
    assert maze.north.tolist() == [[False, True, False], [True, True, True]]
    assert maze.east.tolist() == [[True, False, True], [False, False, True]]


def test_the_command_makes_the_same_maze(command):
    for kind in KINDS:
        assert labmouse.generate(kind, seed=7, loops=0.0 if kind == "contest" else 0.1).text() == command(
            "make", kind, "--seed", "7", "--loops", "0" if kind == "contest" else "0.1")


def test_a_border_that_is_open_is_refused():
    north = numpy.ones((4, 4), bool)
    east = numpy.ones((4, 4), bool)
    east[2, 3] = False
    with pytest.raises(labmouse.Error, match=r"\(3,2\)"):
        labmouse.Maze.from_walls(north, east)


@pytest.mark.parametrize("shape", [(0, 3), (3, 0), (65, 2), (2, 65)])
def test_sides_that_no_maze_has_are_refused(shape):
    with pytest.raises(labmouse.Error):
        labmouse.Maze.from_walls(numpy.ones(shape, bool), numpy.ones(shape, bool))


def test_errors_are_those_of_the_command(command, tmp_path):
    broken = tmp_path / "broken.txt"
    broken.write_text("o---o\n| S |\no-x-o\n")
    with pytest.raises(labmouse.Error) as error:
        labmouse.Maze(broken)
    assert str(error.value) == command("show", str(broken)).strip()
    with pytest.raises(labmouse.Error) as error:
        labmouse.Maze("no-such-maze")
    assert str(error.value) == command("show", "no-such-maze").strip()


def test_a_note_about_a_maze_is_a_warning(tmp_path):
    text = "o---o---o\n| G   G  \no   o   o\n| G | G |\no---o---o\n"
    (tmp_path / "open.txt").write_text(text)
    for read in (
        lambda: labmouse.Maze(tmp_path / "open.txt"),
        lambda: labmouse.Maze.parse(text, "open.txt"),
        lambda: labmouse.find_mazes([tmp_path])[0],
    ):
        with pytest.warns(UserWarning, match=r"open\.txt: .*\(1,1\)"):
            assert read().goals == [(0, 0), (1, 0), (0, 1), (1, 1)]


@pytest.mark.filterwarnings("ignore::UserWarning")
@given(st.text(max_size=200))
@settings(max_examples=100, deadline=None)
def test_any_text_is_a_maze_or_an_error(text):
    try:
        labmouse.Maze.parse(text)
    except labmouse.Error:
        pass


def test_a_maze_is_a_key_and_is_drawn():
    maze = labmouse.Maze("contest-01")
    assert {maze: 1}[maze.named("other")] == 1
    assert maze._repr_svg_().startswith("<svg")
    assert maze != 3
