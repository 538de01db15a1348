"""The record, the picture and the replay of one contest."""

import json
import os
import random
import re

import labmouse
import pytest


def test_a_record_is_that_of_the_command(command, tmp_path):
    file, picture = tmp_path / "record.jsonl", tmp_path / "picture.svg"
    command("run", "ariadne", "contest-05", "--seed", "9", "--record", str(file), "--svg", str(picture))
    record = labmouse.run("ariadne", "contest-05", seed=9)
    assert record.text == file.read_text()
    assert record.svg == picture.read_text() == record._repr_svg_()


def test_a_record_that_is_saved_is_replayed_by_the_command(command, tmp_path):
    record = labmouse.run("ariadne", "contest-05", seed=9)
    record.save(tmp_path / "record.jsonl")
    assert (tmp_path / "record.jsonl").read_text() == record.text
    assert f"score {record.score:.3f}" in command("replay", str(tmp_path / "record.jsonl"))


def test_steps_are_what_the_mouse_saw_and_did():
    seen_and_done, dice = [], random.Random(1)

    class Noting:
        def decide(self, seen):
            seen_and_done.append((*seen, dice.choice((-90, 0, 90)), dice.choice((-1, 1, 2, 3))))
            return seen_and_done[-1][3:]

    steps = labmouse.run(Noting, "contest-05", budget=50, debug=True).steps
    assert [tuple(step) for step in steps[["left", "ahead", "right", "rotation", "movement"]].tolist()] == seen_and_done
    assert len(set(seen_and_done)) > 10


def test_steps_add_up_to_the_score():
    record = labmouse.run("ariadne", "contest-05")
    steps = record.steps
    assert steps["step"].tolist() == list(range(1, len(steps) + 1))
    assert record.score == (steps["run"] == 1).sum() + (steps["run"] == 0).sum() / 30
    assert (steps[0]["x"], steps[0]["y"]) == record.maze.start
    with pytest.raises(ValueError):
        steps["x"] = 0


def test_a_contest_in_seconds_is_one_of_the_race():
    race = json.loads(labmouse.race("certify", "contest-05", world="seconds").to_json())
    expected = race["groups"][0]["mice"][0]["results"][0]
    record = labmouse.run("certify", "contest-05", world="seconds", seed=expected.get("seed", 1))
    for key in expected.keys() - {"microseconds_per_decision"}:
        assert record.figures[key] == expected[key]
    assert record.score is not None and record.bound == labmouse.bound("contest-05", world="seconds")
    with pytest.raises(labmouse.Error):
        record.steps


def test_a_replay_is_one_file_that_asks_for_nothing():
    record = labmouse.run("flood", "contest-05")
    try:
        replay = record.replay()
    except labmouse.Error as error:
        if "LABMOUSE_NO_SKIP" in os.environ:
            raise
        pytest.skip(str(error))
    assert "labmouse-records" in replay.html
    assert not re.search(r"""(?:src|href)=["']https?:""", replay.html)
    assert replay._repr_html_().startswith("<iframe srcdoc=")


def test_a_route_is_that_of_the_command(command):
    expected = json.loads(command("route", "contest-05", "--robot", "half", "--format", "json"))["mazes"][0]
    assert labmouse.route("contest-05", robot="half").data == expected
