"""Any log gives estimates with intervals: expressions, gaps, limited duties, known formats, several logs together, and coverage."""

import math
import os
import sys
from pathlib import Path

import labmouse
import numpy as np
import pytest

pytest.importorskip("scipy")
from labmouse import fit  # noqa: E402
from labmouse.fit._commands import fit as fit_command  # noqa: E402
from labmouse.fit._expressions import Expression  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bench"))
import fit_intervals  # noqa: E402

#: Logs that do not come with the project.
LOGS = Path(os.environ.get("LABMOUSE_LOGS", ROOT.parent / "shared" / "cases" / "logs"))


@pytest.fixture(scope="module")
def robot():
    return fit.base_numbers("classic") | {"motors.sag": 0.0, "variation.encoder_scale": 0.002, "variation.gyro_scale": 0.002}


def driven(duties, gain=4000.0, time=0.15, zone=0.05, step=1, seed=1, row=None):
    """A log of a motor of the first order with friction, from rest. duties: by ms; row: ms from row to row."""
    rate = place = 0.0
    places, share = [], -math.expm1(-1e-3 / time)
    for duty in np.clip(duties, -1.0, 1.0):
        places.append(place)
        free = rate + share * (gain * duty - rate)
        rate = math.copysign(max(0.0, abs(free) - share * gain * zone), free)
        place += 1e-3 * rate
    every = row or step
    noise = np.random.default_rng(seed).normal(scale=0.05, size=len(places))
    values = {"left": np.array(duties, dtype=float), "right": np.array(duties, dtype=float), "travel": np.array(places) + noise}
    return fit.Log(np.arange(len(duties), dtype=float)[::every].copy(), {role: some[::every].copy() for role, some in values.items()})


def stairs(*levels, each=300):
    return np.repeat(levels, each)


ROUND = stairs(0.0, 0.4, 0.2, 0.0, 0.3, 0.1, 0.5, 0.0)


def within(estimate, truth):
    low, high = estimate.interval
    return low <= truth <= high


# Expressions of columns


@pytest.mark.parametrize(
    "text, value",
    [
        ("(a + b) / 10", 0.5),
        ("a + b * 2", 8.0),
        ("-a*2-b", -7.0),
        ("ff.tra+pwm-left", 24.0),
        ("a b/4", 5.0),
        ("#2 - #1", 1.0),
        ("180*pi/(a-1)", 180.0 * math.pi),
        ("1e-1*a", 0.2),
        ("3", 3.0),
    ],
)
def test_an_expression_has_the_value_of_its_columns(text, value):
    names = ["a", "b", "ff.tra", "pwm-left", "a b", "left"]
    values = dict(enumerate([2.0, 3.0, 7.0, 17.0, 20.0, 1000.0]))
    assert Expression(text, names, len(names)).of(values) == pytest.approx(value)


@pytest.mark.parametrize("text", ["a ** 2", "a // 2", "(a", "a b", "a(b)", "()", "(" * 400 + "a" + ")" * 400, "a+" * 600 + "a"])
def test_what_is_no_sum_or_product_is_refused(text):
    with pytest.raises(labmouse.Error):
        Expression(text, ["a", "b"], 2)


@pytest.mark.parametrize("text", ["a b c", "1 if a", "__import__('os')", "exit", "a.__class__", "lambda", "#3", "#0", "b2"])
def test_only_names_of_columns_are_known(text):
    with pytest.raises((LookupError, labmouse.Error)):
        Expression(text, ["a", "b"], 2)


def test_columns_of_a_log_may_be_expressions(tmp_path):
    path = tmp_path / "log.csv"
    path.write_text("ms,fwd_mv,rot_mv,gz\n0,700,0,180\n2,1400,700,90\n")
    log = fit.read_log(path, "time = ms, left = (fwd_mv - rot_mv) / 7000, right = (fwd_mv + rot_mv) / 7000, gyro = gz * pi / 180")
    assert log["left"].tolist() == pytest.approx([0.1, 0.1])
    assert log["right"].tolist() == pytest.approx([0.1, 0.3])
    assert log["gyro"].tolist() == pytest.approx([math.pi, math.pi / 2.0])
    assert fit.read_log(path, "time=ms,duty=fwd_mv/7000+rot_mv/700*2")["duty"].tolist() == pytest.approx([0.1, 2.2])
    with pytest.raises(labmouse.Error, match=f"{path}:3:12: error: "):
        fit.read_log(path, "time=ms,duty=gz/(fwd_mv-1400)")
    with pytest.raises(labmouse.Error, match="'fwdmv'"):
        fit.read_log(path, "time=ms,duty=(fwdmv+rot_mv)/7000")


# Any excitation


def test_one_drive_is_enough(robot):
    fitted = fit.fit_log(driven(ROUND), robot)
    drive = fitted.drive
    assert drive.gain.sure and drive.time.sure and drive.dead_zone.sure
    assert within(drive.gain, 4000.0) and within(drive.time, 0.15) and within(drive.dead_zone, 0.05)
    assert drive.gain.error < 0.02 * drive.gain.value and not drive.by_input


@pytest.mark.parametrize("row", [2, 5, 10, 20])
def test_slow_rows_give_intervals_that_contain_the_truth(robot, row):
    fine, coarse = (fit.fit_log(driven(ROUND, row=one), robot).drive for one in (1, row))
    assert within(coarse.gain, 4000.0) and within(coarse.time, 0.15)
    assert coarse.time.error > 0.9 * fine.time.error


@pytest.mark.parametrize("late", [0, 1])
def test_duties_of_a_row_may_be_those_of_the_row_before(robot, late):
    log = driven(ROUND, row=10)
    for side in ("left", "right"):
        log.values[side] = np.concatenate([np.zeros(late), log[side][: len(log.times) - late]])
    drive = fit.fit_log(log, robot).drive
    assert within(drive.gain, 4000.0) and within(drive.time, 0.15)
    assert drive.time.error < 0.004


def test_a_dead_zone_of_the_input_is_recognised(robot):
    duties = np.concatenate([ROUND, stairs(0.0, 0.3, 0.0, 0.2, -0.03, 0.4, 0.0)])
    free = np.sign(duties) * np.maximum(0.0, np.abs(duties) - 0.05)
    log = driven(free, zone=0.0)
    log.values["left"] = log.values["right"] = duties
    drive = fit.fit_log(log, robot).drive
    assert drive.by_input
    assert within(drive.gain, 4000.0) and within(drive.dead_zone, 0.05)


def test_duties_beyond_the_limit_count_as_one(robot):
    duties = stairs(0.0, 0.3, 1.6, 0.2, -1.2, 0.0, 0.5, 0.0, each=200)
    fitted = fit.fit_log(driven(duties), robot)
    assert fitted.saturated == 400
    assert within(fitted.drive.gain, 4000.0) and within(fitted.drive.time, 0.15)


def test_a_battery_that_is_assumed_to_sag_widens_the_intervals(robot):
    plain, sagging = (fit.fit_log(driven(ROUND), robot | {"motors.sag": sag}).drive for sag in (0.0, 0.05))
    assert sagging.gain.error > 4.0 * plain.gain.error
    assert within(sagging.gain, 4000.0) and within(sagging.dead_zone, 0.05)


def test_voltages_of_axes_are_duties_of_motors(robot):
    log = driven(ROUND)
    duties, volts = log["left"], robot["motors.volts"]
    other = fit.Log(log.times, {"travel": log["travel"], "forward_volts": volts * duties, "rotation_volts": 0.1 * volts * duties})
    motion = fit.motion_of(other, robot)
    assert motion.left == pytest.approx(0.9 * duties) and motion.right == pytest.approx(1.1 * duties)
    assert within(fit.fit_log(other, robot).drive.gain, 4000.0)


def test_travel_heading_and_speeds_are_motion(robot):
    times = np.arange(0.0, 11.0)
    wheels = fit.motion_of(fit.Log(times, {"left_travel": times, "right_travel": 3.0 * times}), robot)
    assert wheels.way == pytest.approx(2.0 * times)
    assert wheels.angle == pytest.approx(2.0 * times / (2.0 * robot["body.half_track"]))
    axes = fit.motion_of(fit.Log(times, {"forward_speed": 500.0 + 0.0 * times, "heading": 9.0 * times}), robot)
    assert axes.way == pytest.approx(0.5 * times) and axes.angle == pytest.approx(times * math.pi / 20.0)
    turned = fit.motion_of(fit.Log(times, {"rotation_speed": 2.0 + 0.0 * times}), robot)
    assert turned.angle == pytest.approx(2e-3 * times) and not turned.by_gyro


def test_a_log_with_gaps_is_fitted_around_them(robot, tmp_path):
    log = driven(np.concatenate([ROUND, ROUND]))
    keep = (log.times < 700.0) | ((log.times > 1000.0) & (log.times < 2200.0)) | (log.times > 2900.0)
    path = tmp_path / "log.csv"
    rows = np.column_stack([log.times, log["left"], log["travel"]])[keep]
    path.write_text("ms,u,x\n" + "".join(f"{t:g},{u:g},{x:.4f}\n" for t, u, x in rows))
    fitted = fit.fit_log(fit.read_log(path, "time=ms,duty=u,travel=x"), robot)
    assert len(fitted.motion.spans) == 3
    assert within(fitted.drive.gain, 4000.0) and within(fitted.drive.time, 0.15)
    assert fitted.drive.gain.error < 0.02 * fitted.drive.gain.value


# Several logs


def test_logs_that_determine_little_alone_do_so_together(robot):
    short = [fit.fit_log(driven(stairs(0.0, level, 0.0, each=220), seed=i), robot) for i, level in enumerate((0.15, 0.3, 0.45, 0.6))]
    together = fit.pooled(short)["motors.drive_gain"]
    assert together.sure and within(together, 4000.0)
    assert together.error < min(one.drive.gain.error for one in short)


def test_logs_that_are_too_short_alone_are_fitted_together(robot):
    short = [fit.fit_log(driven(stairs(0.0, level, 0.0, each=60), row=10, seed=i), robot) for i, level in enumerate(np.linspace(0.13, 0.2, 10))]
    assert all(one.drive.refusal for one in short)
    together = fit.pooled(short)["motors.drive_gain"]
    assert within(together, 4000.0) and together.error < together.value


def test_an_axis_that_one_log_lacks_comes_from_the_other(robot):
    driving, standing = fit.fit_log(driven(ROUND), robot), fit.fit_log(driven(0.0 * ROUND), robot)
    assert standing.drive.refusal
    both = fit.robot_of_logs([standing, driving], "classic")
    assert within(both.numbers["motors.drive_gain"], 4000.0)
    assert "driving" not in both.warning


# Estimates that are unsure, and what is missing


def test_an_unsure_number_has_an_interval_and_a_reason(robot):
    steady = fit.fit_log(driven(stairs(0.0, 0.3, each=180), row=5), robot)
    number = steady.drive.gain
    assert number.known and number.unsure and within(number, 4000.0)
    result = fit.robot_of_logs([steady], "classic")
    assert result.warning
    assert "unsure" in result.text and "95 %" in result.text


def test_what_is_missing_names_an_experiment(robot):
    lines = [line for line in fit.robot_of_logs([fit.fit_log(driven(ROUND), robot)], "classic").text.split("\n") if line.startswith("# missing: ")]
    assert any("motors.turn_gain" in line for line in lines)
    assert not any("motors.drive_gain" in line for line in lines)


def test_intervals_are_those_of_students_t():
    assert fit.Estimate(10.0, 1.0).interval == pytest.approx((10.0 - 1.96, 10.0 + 1.96), abs=1e-3)
    assert fit.Estimate(10.0, 1.0, freedom=4.0).interval == pytest.approx((10.0 - 2.776, 10.0 + 2.776), abs=1e-3)
    low, high = fit.Estimate(10.0, 10.0, positive=True).interval
    assert 0.0 < low < 10.0 < high and low * high == pytest.approx(100.0)
    assert not fit.Estimate(1.0).known and math.isnan(fit.Estimate(1.0).interval[0])
    wider = fit.Estimate(10.0, 3.0, freedom=5.0).with_error(4.0)
    assert wider.error == pytest.approx(5.0) and wider.freedom == pytest.approx(5.0 * (5.0 / 3.0) ** 4)


# Known formats


def profile(names, repeats=4, turn=False):
    """A report_profile: position and angle in whole mm and degrees, voltages in mV, every 10 ms."""
    volts = np.concatenate([np.linspace(1.1, 2.4, 15), np.full(50, 1.4), np.full(10, -0.5), np.full(80, 0.0)])
    log = driven(np.repeat(volts, 10) / 8.0, gain=8.0 * (500.0 if not turn else 800.0), time=0.2, zone=0.0)
    rows = []
    for volt, place in zip(volts, log["travel"][::10]):
        along, around = (0.0, place) if turn else (place, 0.0)
        rows.append(f"{along:6.0f}{around:6.0f}{0:6d}{0:6d}{0:6d}{0:6d}{0 if turn else 1000 * volt:6.0f}{1000 * volt if turn else 0:6.0f}")
    return ("\n".join([names] if names else []) + "\n" if names else "") + "\n".join([rows[0]] * repeats + rows[1:]) + "\n"


NAMES = "robotPos robotAngle fwdPos fwdSpeed rotpos rotSpeed fwdmVolts rotmVolts"


@pytest.mark.parametrize("names, preset", [(f"time {NAMES}", ""), (NAMES, ""), ("", "ukmars"), (f"time {NAMES}", "ukmars")])
def test_a_report_of_ukmars_is_read(robot, tmp_path, names, preset):
    path = tmp_path / "profile.txt"
    path.write_text(profile(names))
    log = fit.read_log(path, preset=preset)
    assert log.times.tolist() == [10.0 * i for i in range(155)]
    assert log["forward_volts"][:2] == pytest.approx([1.1, 1.193], abs=0.001)
    drive = fit.fit_log(log, robot).drive
    assert within(drive.gain, 4000.0) and within(drive.time, 0.2)
    path.write_text(profile(names, turn=True))
    turn = fit.fit_log(fit.read_log(path, preset=preset), robot).turn
    # Degrees/s per volt of rotation: the motors get it with opposite signs, so their duties differ by twice as much.
    assert within(turn.gain, math.radians(800.0) * 8.0 / 2.0)


def test_a_report_of_ukmars_with_its_time_keeps_it(tmp_path):
    path = tmp_path / "profile.txt"
    path.write_text("time " + NAMES + "\n" + "".join(f"{20 * i} {i} 0 0 0 0 0 1000 0\n" for i in range(4)))
    assert fit.read_log(path).times.tolist() == [0.0, 20.0, 40.0, 60.0]


def test_a_log_of_the_controller_of_kerise_is_read(tmp_path):
    parts = ["ref_v", "est_v", "ref_a", "est_a", "ff", "fbp", "fbi", "fbd"]
    names = [f"{part}.{axis}" for axis in ("tra", "rot") for part in parts]
    row = [300, 290, 0, 0, 0.1, 0.02, 0.03, -0.01, 2, 1.5, 0, 0, 0.04, 0.02, 0.01, 0.01]
    path = tmp_path / "pid.csv"
    for head, preset in ((",".join(names) + "\n", ""), ("", "kerise")):
        path.write_text(head + (",".join(map(str, row)) + "\n") * 3)
        log = fit.read_log(path, preset=preset)
        assert log.times.tolist() == [0.0, 1.0, 2.0]
        assert log["left"][0] == pytest.approx(0.14 - 0.04) and log["right"][0] == pytest.approx(0.14 + 0.04)
        assert log["forward_speed"][0] == 290.0 and log["rotation_speed"][0] == 1.5


def test_an_unknown_format_needs_columns(tmp_path, capsys):
    path = tmp_path / "log.csv"
    path.write_text("a,b\n1,2\n3,4\n")
    for more in ([], ["--preset", "ukmars"], ["--preset", "kerise"], ["--preset", "ukmars", "--columns", "time=a"]):
        assert fit_command([str(path), *more]) == 2
        out, err = capsys.readouterr()
        assert out == "" and err.count("\n") == 1 and "error: " in err
    with pytest.raises(labmouse.Error):
        fit.read_log(path, preset="no-such-format")


# Logs that do not come with the project. The true numbers are those of their description.


def log_of(name):
    if not (LOGS / name).exists():
        pytest.skip(f"no log {LOGS / name}; set LABMOUSE_LOGS")
    return LOGS / name


@pytest.mark.parametrize("name, preset", [("ukmars-forward.txt", ""), ("ukmars-no-header.txt", "ukmars")])
def test_the_forward_profile_of_ukmars_gives_its_motor(robot, name, preset):
    drive = fit.fit_log(fit.read_log(log_of(name), preset=preset), robot).drive
    volts = robot["motors.volts"]
    assert drive.gain.sure and drive.time.sure and drive.dead_zone.sure
    assert within(drive.gain, 475.0 * volts) and within(drive.time, 0.19) and within(drive.dead_zone, 0.34 / volts)


def test_the_turning_profile_of_ukmars_gives_its_motor(robot):
    turn = fit.fit_log(fit.read_log(log_of("ukmars-turn.txt")), robot).turn
    assert turn.gain.known and turn.time.known
    assert within(turn.gain, math.radians(775.0) * robot["motors.volts"] / 2.0) and within(turn.time, 0.21)


def test_steps_of_the_duty_give_the_motor(robot, tmp_path):
    columns = "time=t_ms, left=duty_left, right=duty_right, left_travel=left_mm, right_travel=right_mm, gyro=gyro_dps*pi/180"
    fitted = fit.fit_log(fit.read_log(log_of("duty-step.csv"), columns), robot)
    assert fitted.saturated == 10
    assert within(fitted.drive.gain, 4200.0) and within(fitted.drive.time, 0.15) and within(fitted.drive.dead_zone, 0.05)


# Coverage: bench/fit_intervals.py has 200 cases.


def test_intervals_contain_the_truth_in_most_cases():
    cases = [fit_intervals.case((number, [(1000, 500, 100)[number % 3]])) for number in range(8)]
    every = [found for one in cases for found in one.values()]
    assert len(every) >= 40
    # With intervals of half the width, about two thirds contain it.
    assert sum(one[0] for one in every) >= 0.86 * len(every)
    sure = [one[1] for one in cases[0].values()]
    assert np.median(sure) < 0.2
