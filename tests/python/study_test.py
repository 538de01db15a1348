"""Studies: the numbers of the command."""

import json

import labmouse

MAZES = ["contest-01", "contest-02", "contest-05", "capstone-1"]


def test_a_study_gives_the_numbers_of_the_command(command):
    words = ["--mazes", *MAZES, "--folds", "2", "--format", "json"]
    expected = json.loads(command("study", "--mice", "flood,certify,ariadne", *words))
    study = labmouse.study("flood,certify,ariadne", MAZES, folds=2)
    assert study.complete
    assert study.comparisons.to_dict("records") == expected["comparisons"]
    assert sorted(study.table["maze"]) == sorted(MAZES)
    assert study._repr_svg_().startswith("<svg")
