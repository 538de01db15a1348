"""A mistake of the user raises labmouse.Error with one line that says what it is about, never an error of nanobind."""

import labmouse
import numpy
import pytest

learn = pytest.importorskip("labmouse.learn")
MAZE = labmouse.generate("wilson", size=4)
FLAGS = numpy.ones((4, 4), bool)


class Still:
    def decide(self, seen):
        return "forfeit"


def stepped(actions):
    envs = learn.ContestVectorEnv(4)
    envs.reset(seed=1)
    envs.step(actions)


def stepped_alone(action):
    env = learn.ContestEnv()
    env.reset(seed=1)
    env.step(action)


#: Wrong calls, and the words that each message must contain: the wrong value or its subject, and what to give instead.
WRONG = {
    "an unknown mouse": (lambda: labmouse.race("flod"), ["'flod'", "'flood'"]),
    "an unknown mouse beside one of Python": (lambda: labmouse.race({"a": Still, "b": "flod"}), ["'flod'", "'flood'"]),
    "a parameter": (lambda: labmouse.race("flood:strid=1"), ["flood", "'strid'", "'stride'"]),
    "the value of a parameter": (lambda: labmouse.race("flood:stride=x"), ["flood", "'stride'", "'x'"]),
    "a number for a mouse": (lambda: labmouse.race([3]), ["int", "decide"]),
    "no mice": (lambda: labmouse.race([]), ["no mice"]),
    "a number for a name": (lambda: labmouse.race({3: "flood"}), ["3", "name"]),
    "an object for a mouse": (lambda: labmouse.race([Still()]), ["Still", "class"]),
    "two mice of one name": (lambda: labmouse.race([Still, Still]), ["'Still'", "name"]),
    "a mouse that mms does not know": (lambda: labmouse.race([Still], MAZE, world="mms"), ["'Still'", "mms:"]),
    "a number for a maze": (lambda: labmouse.race("flood", 3), ["3", "maze"]),
    "a number among mazes": (lambda: labmouse.race("flood", [MAZE, 3]), ["3", "maze"]),
    "a number for the maze of a run": (lambda: labmouse.run("flood", 3), ["3", "maze"]),
    "a number for the path of a maze": (lambda: labmouse.Maze(3), ["3", "path"]),
    "a number among paths of mazes": (lambda: labmouse.mazes(3), ["3", "maze"]),
    "a maze that is not there": (lambda: labmouse.race("flood", "contest-99"), ["contest-99", "contest-09"]),
    "a text that is no maze": (lambda: labmouse.Maze.parse("xx\nyy", "mine"), ["mine", "drawing"]),
    "a number for a text": (lambda: labmouse.Maze.parse(3), ["text", "3"]),
    "a kind of mazes": (lambda: labmouse.generate("contst"), ["'contst'", "'contest'"]),
    "a size": (lambda: labmouse.generate(size=3.5), ["3.5", "size"]),
    "a size of three sides": (lambda: labmouse.generate(size=(1, 2, 3)), ["(1, 2, 3)", "size"]),
    "a seed below 0": (lambda: labmouse.generate(seed=-1), ["seed", "-1", "from 0"]),
    "a seed that is a text": (lambda: labmouse.generate(seed="a"), ["seed", "'a'", "whole number"]),
    "loops": (lambda: labmouse.generate(loops=2), ["loops", "2", "from 0 to 1"]),
    "walls in one row": (lambda: labmouse.Maze.from_walls(FLAGS[0], FLAGS[0]), ["north", "(height, width)"]),
    "a large maze in lists": (lambda: labmouse.Maze.from_walls([[True] * 64] * 64, FLAGS), ["north", "bool"]),
    "walls in lists": (lambda: labmouse.Maze.from_walls(FLAGS, [[True]]), ["east", "bool"]),
    "walls of two shapes": (lambda: labmouse.Maze.from_walls(FLAGS[:3], FLAGS), ["(3, 4)", "(4, 4)"]),
    "a start": (lambda: labmouse.Maze.from_walls(FLAGS, FLAGS, start=(9, 0)), ["start", "(9,0)", "4x4"]),
    "a start of three": (lambda: labmouse.Maze.from_walls(FLAGS, FLAGS, start=(1, 0, 1)), ["start", "(1, 0, 1)", "(x, y)"]),
    "no goals": (lambda: labmouse.Maze.from_walls(FLAGS, FLAGS, goals=[]), ["goal"]),
    "a heading": (lambda: MAZE.with_start((0, 0), "nort"), ["'nort'", "'north'"]),
    "a text for a cell": (lambda: MAZE.with_start("a"), ["start", "'a'", "(x, y)"]),
    "a format": (lambda: MAZE.text("draw"), ["'draw'", "'drawing'"]),
    "a number for the path of a file": (lambda: MAZE.save(3), ["path", "3"]),
    "no runs": (lambda: labmouse.race("flood", runs=0), ["runs", "0", "1 to 1000000"]),
    "a text for runs": (lambda: labmouse.race("flood", runs="3"), ["runs", "'3'", "1 to 1000000"]),
    "a seed of a race": (lambda: labmouse.race("flood", seed=-1), ["seed", "-1", "from 0"]),
    "a seed of a run": (lambda: labmouse.run("flood", MAZE, seed=1.5), ["seed", "1.5", "whole number"]),
    "jobs": (lambda: labmouse.race("flood", jobs=None), ["jobs", "None", "0 to 1024"]),
    "a budget": (lambda: labmouse.race("flood", budget="many"), ["budget", "many", "1 to"]),
    "a setting": (lambda: labmouse.race("flood", budgt=3), ["'budgt'"]),
    "a world": (lambda: labmouse.race("flood", world="sec"), ["'sec'", "seconds"]),
    "a number for a world": (lambda: labmouse.race("flood", world=3), ["world", "3"]),
    "a robot": (lambda: labmouse.race("flood", world="seconds", robot="clasic"), ["'clasic'", "'classic'"]),
    "the robot of a route": (lambda: labmouse.route(MAZE, robot=3), ["robot", "3"]),
    "a store": (lambda: labmouse.race("flood", store=3), ["store", "3", "path"]),
    "folds": (lambda: labmouse.study("flood,certify", folds="5"), ["folds", "'5'", "whole number"]),
    "a mouse of another race": (lambda: labmouse.race("flood", MAZE).compare("a", "flood"), ["'a'"]),
    "an observation": (lambda: learn.ContestEnv(observation="sight"), ["'sight'", "sighting"]),
    "an order": (lambda: learn.ContestEnv(order="x"), ["'x'", "drawn"]),
    "a set of mazes": (lambda: learn.MazeSet("tain"), ["tain", "train"]),
    "the number of a maze below 0": (lambda: learn.MazeSet()[-1], ["-1", "from 0"]),
    "a text for the number of a maze": (lambda: learn.MazeSet()["x"], ["'x'", "whole number"]),
    "a turn by half a right angle": (lambda: learn.number_of(45, 1), ["45", "1"]),
    "the file of a learned mouse": (lambda: learn.Learned.load("nowhere.json"), ["nowhere.json", "No such file"]),
    "the size of a set": (lambda: learn.MazeSet(size=(3,)), ["size", "(3,)", "(width, height)"]),
    "the budget of an environment": (lambda: learn.ContestEnv(budget="x"), ["budget", "'x'", "1 to 32767"]),
    "half an environment": (lambda: learn.ContestVectorEnv(2.5), ["num_envs", "2.5", "whole number"]),
    "an action": (lambda: stepped_alone(99), ["action", "99", "0 to 21"]),
    "a text for an action": (lambda: stepped_alone("x"), ["action", "'x'", "0 to 21"]),
    "too few actions": (lambda: stepped(numpy.zeros(3, int)), ["actions", "(3,)", "(4,)"]),
    "actions in columns": (lambda: stepped(numpy.zeros((4, 1), int)), ["actions", "(4, 1)", "(4,)"]),
    "texts for actions": (lambda: stepped(["x"] * 4), ["actions", "'x'"]),
    "memory of another kind": (lambda: learn.ContestVectorEnv(4).draw_valid_actions(numpy.zeros(4, numpy.int32)), ["int32", "int64"]),
    "too few seeds": (lambda: learn.ContestVectorEnv(4).reset(seed=[1]), ["1 seeds", "4"]),
    "too few in a mask": (lambda: learn.ContestVectorEnv(4).reset(options={"reset_mask": FLAGS[0, :3]}), ["reset_mask", "(3,)", "(4,)"]),
    "weights": (lambda: learn.Learned([1, 2]), ["29", "2"]),
}


@pytest.mark.parametrize("what", WRONG)
def test_what_is_wrong_is_said_in_one_line(what):
    act, words = WRONG[what]
    with pytest.raises(labmouse.Error) as error:
        act()
    (line,) = str(error.value).splitlines()
    assert [word for word in words if word not in line] == [], line
    assert len(line) < 200


def test_a_file_that_is_wrong_is_said_with_its_place(tmp_path):
    broken = tmp_path / "broken.txt"
    broken.write_text("o---o\n| S |\no-x-o\n")
    for act in (lambda: labmouse.Maze(broken), lambda: labmouse.race("flood", broken), lambda: labmouse.bound(broken)):
        with pytest.raises(labmouse.Error, match=r"^[^\n]*broken\.txt:3:3: error: [^\n]*$"):
            act()
    for act in (lambda: learn.Learned.load(broken), lambda: labmouse.route(MAZE, robot=broken)):
        with pytest.raises(labmouse.Error, match=r"^[^\n]*broken\.txt[^\n]*: error: [^\n]*$"):
            act()


def test_an_answer_that_cannot_be_shown_is_a_forfeit():
    class Unspeakable:
        def __repr__(self):
            raise RuntimeError("no")

    class Mouse:
        def decide(self, seen):
            return Unspeakable()

    record = labmouse.run(Mouse, MAZE)
    assert record.outcome == "forfeit: invalid answer" and "cannot be shown" in record.last_words
