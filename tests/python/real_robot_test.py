"""The map of a real robot, from the bytes that it sends."""

import labmouse
import pytest

RING = "o---o---o\n| G   G |\no   o   o\n| G | G |\no---o---o\n"
STREAM = b"\nstart *40\n0 0 N 101 batt=7900\xff\n0 0 N 101\n0 1 N 11? state=a\n1 1 E 10"


def test_lines_are_events_however_they_arrive():
    whole = labmouse.RealRobot(2, 2)
    events = whole.feed(STREAM)
    assert events == [{"line": 2, "restart": True, "fields": {}, "findings": ["line 2: restart"]}]
    robot = labmouse.RealRobot(2, 2)
    events = robot.feed(STREAM.replace(b" *40", b"")) + robot.feed(b"1\n")
    assert [event["line"] for event in events] == [2, 4, 5, 6]
    assert events[2] == {
        "line": 5,
        "restart": False,
        "cell": (0, 1),
        "heading": "north",
        "walls": {"north": True, "west": True},
        "fields": {"state": "a"},
        "findings": [],
    }
    assert (robot.lines, robot.noise) == (6, 1)
    assert robot.pose == (1, 1, "east")
    assert robot.fields == {"state": "a"}
    parted = labmouse.RealRobot(2, 2)
    for i in range(len(STREAM)):
        parted.feed(STREAM[i : i + 1])
    assert str(parted) == str(whole)


def test_the_map_is_that_of_the_command(command, tmp_path):
    stream = b"0 0 N 101\n0 1 N 110\n0 1 N 111\n"
    (tmp_path / "robot.log").write_bytes(stream)
    (tmp_path / "true.txt").write_text(RING)
    robot = labmouse.RealRobot(maze=labmouse.Maze.parse(RING))
    findings = [finding for event in robot.feed(stream) for finding in event["findings"]]
    printed = command("live", str(tmp_path / "robot.log"), "--against", str(tmp_path / "true.txt"), "--save", str(tmp_path / "map.txt"))
    assert printed == "".join(finding + "\n" for finding in findings) + str(robot)
    assert len(findings) == 2 and len(robot.contradictions) == 1
    assert (tmp_path / "map.txt").read_text() == robot.text


def test_drawings_are_events():
    robot = labmouse.RealRobot(2, 2)
    (event,) = robot.feed(RING.encode())
    assert event["drawing"] == RING == robot.text
    assert robot.pose is None


def test_sizes_that_no_maze_has_are_errors():
    with pytest.raises(labmouse.Error, match="0x65"):
        labmouse.RealRobot(0, 65)
