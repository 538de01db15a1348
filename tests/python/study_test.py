"""Studies have the same numbers as the command."""

import json

import labmouse
import pytest

MAZES = ["contest-01", "contest-02", "contest-05", "capstone-1"]


@pytest.mark.parametrize("words, options", [
    (["--folds", "3"], {"folds": 3}), (["--folds", "4", "--no-learning"], {"folds": 4, "learning": False}),
])
def test_its_folds_and_whether_mice_learn_are_those_of_the_command(command, words, options):
    mice = "ariadne:prior=contest,flood"
    expected = json.loads(command("study", "--mice", mice, "--mazes", *MAZES, *words, "--format", "json"))
    study = labmouse.study(mice, MAZES, **options)
    assert [study.data[key] for key in ("folds", "learning", "comparisons")] == [
        expected[key] for key in ("folds", "learning", "comparisons")]
    taught = labmouse.study(mice, MAZES, folds=4)
    assert taught.comparisons.to_dict("records") != study.comparisons.to_dict("records")


def test_a_study_gives_the_numbers_of_the_command(command):
    words = ["--mazes", *MAZES, "--folds", "2", "--format", "json"]
    expected = json.loads(command("study", "--mice", "flood,certify,ariadne", *words))
    study = labmouse.study("flood,certify,ariadne", MAZES, folds=2)
    assert study.complete
    assert study.comparisons.to_dict("records") == expected["comparisons"]
    assert sorted(study.table["maze"]) == sorted(MAZES)
    assert study._repr_svg_().startswith("<svg")


@pytest.mark.parametrize("world", ["steps", "seconds", "physical"])
def test_a_study_names_its_mice_and_has_the_contests_of_the_command(command, world):
    words = ["--mice", "flood,certify", "--mazes", *MAZES[:2], "--folds", "2", "--world", world]
    study = labmouse.study("flood,certify", MAZES[:2], folds=2, world=world)
    assert "certify, flood" in repr(study)
    assert study.comparisons.to_dict("records") == json.loads(command("study", *words, "--format", "json"))["comparisons"]
