"""Comparisons until a verdict have the same numbers as the command."""

import json

import labmouse
import pytest


class Still:
    """Never arrives."""

    def decide(self, seen):
        return "forfeit"


def test_a_comparison_gives_the_verdicts_of_the_command(command):
    words = ["--generator", "prim", "--size", "6x6", "--loops", "0.1", "--seed", "3", "--better-by", "0.05", "--format", "json"]
    expected = json.loads(command("compare", "random", "flood", "certify", *words))
    found = labmouse.compare("random", "flood,certify", generator="prim", size=6, loops=0.1, seed=3, better_by=0.05)
    assert found.complete and found.data == expected
    assert found.table["verdict"].tolist() == ["better", "better"]
    assert "against random" in repr(found) and "against random" in str(found)
    with pytest.raises(labmouse.Error, match="several"):
        found.verdict  # noqa: B018


def test_the_first_mouse_is_first_whatever_its_name_and_kind():
    small = {"generator": "prim", "size": 5}
    assert labmouse.compare(Still, {"a": "flood"}, **small).data["first"] == "Still"
    found = labmouse.compare("flood", {"a": Still, "b": "certify"}, most=64, **small)
    assert found.data["first"] == "flood"
    assert dict(zip(found.table["mouse"], found.table["verdict"]))["a"] == "worse"


def test_a_list_is_drawn_from_and_a_store_keeps_all(tmp_path):
    order = dict(mazes=["island-8", "spiral-9"], store=tmp_path / "all.db")
    once = labmouse.compare("flood", "flood:stride=1", **order)
    assert once.data["exact"] and once.data["raced_in"] == 2 and once.from_store == 0
    again = labmouse.compare("flood", "flood:stride=1", **order)
    assert again.data == once.data and again.from_store == 4


@pytest.mark.parametrize(("change", "words"), [
    ({"better_by": 0}, "better_by"), ({"alpha": 0.9}, "alpha"), ({"test": "sprt"}, "gsprt"), ({"most": 0}, "most"),
    ({"generator": "pim"}, "pim"), ({"first": "flood,certify"}, "first"), ({"candidates": "flood"}, "two mice"), ({"size": 65}, "size"),
])
def test_what_is_wrong_is_named(change, words):
    with pytest.raises(labmouse.Error, match=words):
        labmouse.compare(**{"first": "flood", "candidates": "certify", **change})
