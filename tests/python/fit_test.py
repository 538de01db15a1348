"""Fits of logs and turns recover known parameters within standard errors, and refuse what a log does not determine."""

import dataclasses
import math
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import labmouse
import numpy as np
import pytest
from hypothesis import example, given, settings, strategies as st

pytest.importorskip("scipy")
pytest.importorskip("matplotlib")
from labmouse import fit  # noqa: E402
from labmouse._native import turn_curve  # noqa: E402
from labmouse.fit._columns import ROLES  # noqa: E402
from labmouse.fit._commands import compare, fit as fit_command  # noqa: E402

DRIVEN = (
    "time,left,right,left_count,right_count,gyro*0.00107,volts=millivolts/1000,ir_right,ir_left,way=true_way,"
    "wall_right=true_wall_right,wall_left=true_wall_left"
)
DUTIES = "time,left,right,left_count,right_count,gyro*0.00107"
TRUTH = {"drive": (3000.0, 0.15, 0.06), "turn": (90.0, 0.12, 0.05)}  # gain, time (s), dead zone
IR_GAIN, IR_FALL, FACE = 500.0, 14.0, 42.0


class Simulator:
    """A simple simulated mouse, independent of the body of the physical world: so its code does not test itself."""

    def __init__(self, seed: int, lag: float = 0.0, inverse_square: bool = False) -> None:
        self.dice, self.lag, self.inverse_square = np.random.default_rng(seed), lag, inverse_square
        self.rows: list[tuple[float, ...]] = []
        self.current, self.rate, self.travel, self.wall = [0.0, 0.0], [0.0, 0.0], [0.0, 0.0], math.nan

    def run(self, ticks: int, onwards: float, around: float) -> None:
        steps = 5
        step = 1e-3 / steps
        for _ in range(ticks):
            self.rows.append((onwards - around / 2, onwards + around / 2, *self.travel, self.rate[1], self.wall))
            for _ in range(steps):
                for i, (duty, (gain, time, dead_zone)) in enumerate(zip((onwards, around), TRUTH.values())):
                    self.current[i] += (min(1.0, step / self.lag) if self.lag else 1.0) * (duty - self.current[i])
                    free = self.rate[i] + step / time * (gain * self.current[i] - self.rate[i])
                    self.rate[i] = math.copysign(max(0.0, abs(free) - step / time * gain * dead_zone), free)
                self.travel[0] += (self.rate[0] - 20.0 * self.rate[1]) * step
                self.travel[1] += (self.rate[0] + 20.0 * self.rate[1]) * step

    def drive(self, moves: int) -> fit.Log:
        self.run(500, 0.0, 0.0)
        for move in range(moves):
            self.run(int(self.dice.integers(200, 500)), self.dice.uniform(0.12, 0.42), self.dice.uniform(-0.15, 0.15))
            if move % 5 == 4:
                self.run(300, 0.0, 0.0)
        return self.log()

    def stand(self, places: int, reach: float) -> fit.Log:
        for wall in np.linspace(FACE - reach, FACE + reach, places):
            self.wall = wall
            self.run(100, 0.0, 0.0)
        return self.log()

    def log(self) -> fit.Log:
        left, right, left_way, right_way, turning, wall = np.array(self.rows).T
        noise = self.dice.normal(size=(4, len(wall)))
        places, place = np.unique(wall, return_inverse=True)
        # Distances are measured to 0.2 mm, and the reflectance varies by 2 % between places.
        farther = places - FACE + 0.2 * self.dice.normal(size=len(places))
        level = IR_GAIN * np.exp(-farther / IR_FALL)
        if self.inverse_square:
            level = IR_GAIN * (28.0 / (28.0 + farther)) ** 2 + 60.0
        level *= 1.0 + 0.02 * self.dice.normal(size=len(places))
        values = {
            "left": left,
            "right": right,
            "left_count": np.floor((left_way + 0.01 * noise[0]) / 0.1),
            "right_count": np.floor((right_way + 0.01 * noise[1]) / 0.1),
            "gyro": turning + 0.004 * noise[2],
        }
        if not np.isnan(wall).all():
            values |= {"wall_left": wall, "ir_left": np.maximum(0.0, np.round(level[place] + 3.0 * noise[3]))}
        return fit.Log(np.arange(len(wall), dtype=float), values)


@pytest.fixture(scope="module")
def robot():
    """The parameters of kerise, with the mm per count and the track of the simulated mouse."""
    changes = {"sensors.count": 0.1, "body.half_track": 20.0, "motors.sag": 0.0, "variation.encoder_scale": 0.002, "sensors.side_angle": math.pi / 2}
    return fit.base_numbers("kerise") | changes


@pytest.fixture(scope="module")
def driven(tmp_path_factory):
    """A log of a nominal kerise (no variation between mice) in a contest maze."""
    path = tmp_path_factory.mktemp("logs") / "run.csv"
    words = "drive --robot kerise --fast --mazes contest-01 --runs 1 --seed 2 --variation 0 --log".split()
    subprocess.run(["labmouse", *words, str(path)], check=True, capture_output=True)
    return str(path)


def test_a_drive_of_the_physical_world_gives_its_robot_back(driven, tmp_path):
    base = fit.base_numbers("kerise")
    fitted = fit.fit_log(fit.read_log(driven, DRIVEN), base)
    numbers = fitted.numbers()
    keys = [f"motors.{axis}_{number}" for axis in ("drive", "turn") for number in ("gain", "time", "dead_zone")]
    for key in [*keys, "motors.turning", "noise.gyro", "sensors.infrared_gain", "sensors.infrared_fall"]:
        # The 99 % quantile (two-sided) of Student's t distribution with 19 degrees of freedom: 20 blocks.
        assert abs(numbers[key].value - base[key]) < 2.86 * numbers[key].error, key
    assert numbers["motors.drive_gain"].error < 0.005 * base["motors.drive_gain"]
    assert numbers["sensors.count"].error < 0.001 * base["sensors.count"]
    assert abs(numbers["sensors.count"].value / base["sensors.count"] - 1.0) < 3.0 * base["variation.encoder_scale"]
    file = tmp_path / "mine.toml"
    result = fit.robot_of_logs([fitted], "kerise")
    file.write_text(result.text, encoding="utf-8")
    assert result.warning == ""
    name, read = fit.robot_numbers(str(file))
    assert read["motors.drive_gain"] == pytest.approx(numbers["motors.drive_gain"].value, rel=1e-4)
    assert read["body.grip"] == base["body.grip"]


def test_a_robot_whose_sensors_are_listed_keeps_them(driven, tmp_path):
    base = fit.base_numbers("beginner")
    fitted = fit.fit_log(fit.read_log(driven, DRIVEN), base)
    assert fitted.drive.gain.known
    assert fitted.infrared.refusal
    file = tmp_path / "mine.toml"
    file.write_text(fit.robot_of_logs([fitted], "beginner").text, encoding="utf-8")
    assert fit.robot_numbers(str(file))[1]["infrared"] == base["infrared"]


def test_a_mouse_of_another_making_is_recovered(robot):
    held = known = 0
    for seed in (1, 2):
        fitted = fit.fit_log(Simulator(seed).drive(30), robot)
        assert fitted.drive.refusal + fitted.turn.refusal + fitted.gyro.refusal == ""
        for motor, (gain, time, dead_zone) in ((fitted.drive, TRUTH["drive"]), (fitted.turn, TRUTH["turn"])):
            assert motor.time.value == pytest.approx(time, abs=0.002)
            assert motor.dead_zone.value == pytest.approx(dead_zone, abs=0.001)
            assert motor.gain.value == pytest.approx(gain, rel=0.01)
            held += abs(motor.gain.value - gain) < 2.09 * motor.gain.error
            known += 1
        assert fitted.gyro.noise.value == pytest.approx(0.004, abs=3.0 * fitted.gyro.noise.error)
    assert held >= known - 1


def test_errors_of_motors_contain_those_of_counts_and_of_the_scale_of_the_gyro(robot):
    log = Simulator(1).drive(30)
    travelled = abs(log["left_count"][-1] + log["right_count"][-1]) / 2.0 * 0.1
    fitted = fit.fit_log(log, robot | {"variation.gyro_scale": 0.15}, way=travelled, way_error=0.1 * travelled)
    assert fitted.drive.gain.error == pytest.approx(0.1 * fitted.drive.gain.value, rel=0.05)
    assert fitted.turn.gain.error == pytest.approx(0.15 * fitted.turn.gain.value, rel=0.05)


def test_a_motor_of_the_second_order_is_less_certain(robot):
    plain = fit.fit_log(Simulator(1).drive(25), robot).drive
    slow = fit.fit_log(Simulator(1, lag=0.02).drive(25), robot).drive
    assert slow.missed > 3.0 * slow.noise
    assert 0.006 < slow.lag < 0.03
    assert slow.gain.error > 5.0 * plain.gain.error
    quick = fit.fit_log(Simulator(1, lag=0.01).drive(25), robot).turn
    for number, truth in ((quick.gain, 90.0), (quick.time, 0.12)):
        assert abs(number.value - truth) < 2.09 * number.error
    slower = fit.fit_log(Simulator(1, lag=0.08).drive(25), robot).turn
    assert slower.missed > 10.0 * slower.noise
    assert slower.gain.interval[0] < 90.0 < slower.gain.interval[1]


def test_a_motion_that_no_model_explains_is_less_certain(robot):
    log = Simulator(1).drive(25)
    plain = fit.fit_log(log, robot).drive
    pushed = np.floor(10.0 * np.sin(2.0 * math.pi * log.times / 250.0))  # counts: a hand pushes the mouse
    for side in ("left_count", "right_count"):
        log.values[side] = log[side] + pushed
    found = fit.fit_log(log, robot).drive
    assert found.missed > 3.0 * plain.missed
    assert abs(found.gain.value - 3000.0) < 2.09 * found.gain.error


def test_infrared_is_recovered_and_another_law_is_unsure(robot):
    found = fit.fit_infrared(Simulator(3).stand(12, 20.0), robot)
    assert found.refusal == ""
    assert found.places == 12
    assert abs(found.fall.value - IR_FALL) < 3.0 * found.fall.error < 3.0
    assert abs(found.gain.value - IR_GAIN) < 3.0 * found.gain.error < 60.0
    other = fit.fit_infrared(Simulator(3, inverse_square=True).stand(12, 20.0), robot)
    assert other.bends and other.gain.unsure
    # Walls whose reflectance alternates between places follow no law.
    log = Simulator(3).stand(12, 20.0)
    places, place = np.unique(log["wall_left"], return_inverse=True)
    log.values["ir_left"] = log["ir_left"] * (1.0 + 0.4 * (-1.0) ** np.arange(len(places)))[place]
    assert fit.fit_infrared(log, robot).bends


def test_an_outlier_hardly_moves_the_infrared(robot):
    log = Simulator(4).stand(14, 20.0)
    plain = fit.fit_infrared(log, robot)
    place = log["wall_left"] == np.unique(log["wall_left"])[6]
    log.values["ir_left"] = np.where(place, 3.0 * log["ir_left"], log["ir_left"])
    spoilt = fit.fit_infrared(log, robot)
    assert spoilt.of_sensor["left"] == pytest.approx(plain.of_sensor["left"], rel=0.05)


def test_what_the_log_does_not_tell_is_refused(robot):
    still = fit.fit_log(Simulator(1).stand(4, 5.0), robot)
    assert all((still.drive.refusal, still.turn.refusal, still.infrared.refusal, still.count.refusal))
    assert set(still.numbers()) <= {"noise.gyro"}
    log = Simulator(1).drive(25)
    log.values["left"], log.values["right"] = -log["left"], -log["right"]
    assert "signs" in fit.fit_log(log, robot).drive.refusal
    bare = fit.fit_log(fit.Log(np.arange(3.0)), robot)
    assert "duties" in bare.drive.refusal and "gyro" in bare.gyro.refusal


def test_logs_with_slow_or_uneven_rows_say_the_same(robot):
    log = Simulator(3).drive(40)
    dice = np.random.default_rng(5)
    for rows in (np.arange(0, len(log.times), 5), np.cumsum(dice.integers(1, 7, size=len(log.times) // 7))):
        thin = fit.Log(log.times[rows] - log.times[rows[0]], {role: values[rows] for role, values in log.values.items()})
        fitted = fit.fit_log(thin, robot)
        assert fitted.drive.gain.value == pytest.approx(3000.0, rel=0.05)
        assert fitted.turn.gain.value == pytest.approx(90.0, rel=0.05)


def test_counts_follow_from_known_places_or_the_whole_way():
    ticks = np.arange(201.0)
    way = np.where(ticks % 20 == 0, 10.0 * ticks, np.nan)
    log = fit.Log(ticks, {"left_count": 40.0 * ticks, "right_count": 42.0 * ticks + (ticks * 7919) % 5, "way": way})
    places = fit.fit_count(log)
    assert places.count.value == pytest.approx(10.0 / 41.0, abs=1e-4)
    assert 0.0 < places.count.error < 2e-4
    whole = fit.fit_count(log, 2000.0, 4.0)
    assert whole.count.error / whole.count.value == pytest.approx(0.002, abs=1e-4)
    # On a short distance, the error is one count.
    short = fit.Log(ticks[:21], {side: np.floor(ticks[:21]) for side in ("left_count", "right_count")})
    few = fit.fit_count(short, 10.0, 0.001).count
    assert few.error / few.value == pytest.approx(1.0 / 20.0)
    # Cumulative errors of 3 mm from place to place.
    slips = np.repeat(np.cumsum(np.random.default_rng(1).normal(scale=3.0, size=11)), 20)[:201]
    slipping = fit.fit_count(fit.Log(ticks, {**log.values, "way": way + slips})).count
    assert abs(slipping.value - 10.0 / 41.0) < 3.0 * slipping.error
    assert slipping.error > 0.003 * slipping.value
    log.values["way"][100] += 300.0  # one position is wrong
    assert fit.fit_count(log).count.value == pytest.approx(10.0 / 41.0, abs=2e-3)


def test_noise_that_is_not_white_is_less_certain(robot):
    def noise(memory, unit=1e-6):
        steps = np.random.default_rng(7).normal(scale=0.01, size=1000)
        values = [0.0]
        for step in steps[1:]:
            values.append(memory * values[-1] + step)
        zero = np.zeros(1000)
        log = fit.Log(np.arange(1000.0), {"gyro": np.round((0.05 + np.array(values)) / unit) * unit, "left": zero, "right": zero})
        motion = fit.motion_of(log, robot)
        assert abs(motion.angle[900] - motion.angle[100]) < 0.01  # the bias is removed
        return fit.fit_gyro(log, motion).noise

    assert noise(0.0, 0.02).value == pytest.approx(0.01, rel=0.07)  # the variance of rounding is subtracted
    assert noise(0.0).value == pytest.approx(0.01, abs=3.0 * noise(0.0).error)
    assert noise(0.0).error < 0.001
    assert noise(0.6).error > 2.0 * noise(0.0).error


def log_of(times, **values):
    return fit.Log(np.array(times, dtype=float), {role: np.array(row, dtype=float) for role, row in values.items()})


PLAIN = {"sensors.count": 0.1, "body.half_track": 20.0, "motors.volts": 4.0, "motors.sag": 0.1}


def test_motion_goes_on_between_rows_and_duties_hold():
    values = {"left": [0.5, 0, 0], "right": [0.1, 0, 0], "left_count": [0, 40, 40], "right_count": [0, 80, 80], "gyro": [0, 2, 2]}
    motion = fit.motion_of(log_of([0, 4, 8], **values), PLAIN)
    assert motion.ticks == 9 and motion.by_gyro
    assert motion.way[[2, 8]] == pytest.approx([3.0, 6.0])  # mean of both wheels: 30 and 60 counts
    assert motion.left[[3, 4]] == pytest.approx([0.5 * 0.97, 0.0])  # sag of 10 % times the mean duty 0.3
    assert motion.angle[4] == pytest.approx(0.001 * (0.5 + 1.0 + 1.5 + 2.0))


def test_motion_takes_the_battery_as_it_was_and_turns_by_encoders_without_a_gyro():
    motion = fit.motion_of(log_of([0, 1, 2], left=[0.5, 0, 0], right=[0.5, 0, 0], volts=[3, 3, 4]), PLAIN)
    assert motion.left[0] == pytest.approx(0.5 * 3.0 / 4.0) and motion.way is None
    turned = fit.motion_of(log_of([0, 1], left_count=[0, -20], right_count=[0, 20]), PLAIN)
    assert turned.angle[1] == pytest.approx(4.0 / 40.0) and not turned.by_gyro


def test_motion_knows_the_driver_of_the_motors():
    log = log_of([0, 1, 2], left=[0.5, 0.01, -0.5], right=[0.5, 0, 0])
    driver = {"motors.left": 0.9, "motors.dead_time": 0.1, "motors.sag": 0.0}
    motion = fit.motion_of(log, PLAIN | driver)
    assert motion.left == pytest.approx([0.36, 0.0, -0.36]) and motion.right[0] == pytest.approx(0.4)
    with pytest.raises(labmouse.Error, match="motors.coast"):
        fit.motion_of(log, PLAIN | {"motors.coast": 1})


def test_rests_are_found_and_the_gyro_is_levelled_there():
    ticks = np.arange(600)
    moved = np.maximum(0, ticks - 300)
    duty = np.where(ticks < 300, 0.0, 0.2)
    motion = fit.motion_of(log_of(ticks, left=duty, right=duty, left_count=2 * moved, right_count=2 * moved, gyro=0.02 + (moved > 0)), PLAIN)
    [(begin, end)] = motion.rests
    assert end - begin > 200 and end < 300
    assert motion.angle[290] == pytest.approx(0.0, abs=1e-9)
    assert motion.angle[599] == pytest.approx(0.299, abs=0.002)


def test_a_counter_that_wraps_is_no_motion():
    with pytest.raises(labmouse.Error, match="left_count=NAME%65536"):
        fit.motion_of(log_of([0, 1], left_count=[65530, 2], right_count=[5, 9]), PLAIN)


def test_several_logs_are_pooled():
    def of(value, error):
        gain = fit.Estimate(value, error)
        return fit.LogFit(fit.Log(np.arange(2.0)), fit.Motion(2), drive=fit.MotorFit(gain=gain))

    alike = fit.pooled([of(3000.0, 10.0), of(3010.0, 20.0)])["motors.drive_gain"]
    assert alike.value == pytest.approx(3002.0)
    assert alike.error == pytest.approx(80.0**0.5)
    # The logs differ by ten of their errors, because the mouse varies between them.
    apart = fit.pooled([of(3000.0, 10.0), of(3100.0, 10.0)])["motors.drive_gain"]
    assert apart.error == pytest.approx(50.0)
    assert fit.pooled([of(3000.0, 10.0)])["motors.drive_gain"] == fit.Estimate(3000.0, 10.0)


def written(tmp_path, text):
    path = tmp_path / "log.csv"
    path.write_bytes(text.encode("utf-8"))
    return path


@pytest.mark.parametrize(
    "text",
    [
        "t,x,g\n0,7,1\n1,8,2\n",
        "\ufefft;x;g\r\n\r\n0;7;1\r\n# so far\n1;8;+2",
        "t\tx\tg\n0\t\t1\n1\t8\t2\n",
        "  t   x g\n 0 7  1 \n1 8 2.0e0\n",
        '"t",x,"g"\n0,7,1\n1,8,2\n',
        't,x,g\n0,"7,5",1\n1,8,2\n',
    ],
)
def test_logs_have_any_separator(tmp_path, text):
    log = fit.read_log(written(tmp_path, text), "time=t,gyro=g")
    assert log.times.tolist() == [0.0, 1.0]
    assert log["gyro"].tolist() == [1.0, 2.0]


def test_columns_have_numbers_factors_wraps_and_periods(tmp_path):
    path = written(tmp_path, "0,65530,3,\n1,4,65535,40.5\n2,65532,2,-\n")
    log = fit.read_log(path, "left_count=#2*-1%65536,right_count=#3%65536,wall_left=#4", period=2.5)
    assert log.times.tolist() == [0.0, 2.5, 5.0]
    assert log["left_count"].tolist() == [-65530.0, -65540.0, -65532.0]
    assert log["right_count"].tolist() == [3.0, -1.0, 2.0]
    assert np.isnan(log["wall_left"]).tolist() == [True, False, True]


@pytest.mark.parametrize(
    "columns, text, place, words",
    [
        ("time=t,gyro=g", "", "", ["empty"]),
        ("time=t,gyro=g", "t,g\n0,1\n", "", ["one row"]),
        ("time=t,gyro=g", "t,gz\n0,1\n", ":1:1", ["'g'", "'gyro'", "t, gz"]),
        ("time=t,gyro=g", "t,g,g\n0,1,2\n1,1,2\n", ":1:5", ["twice", "#3"]),
        ("time=t,gyro=g", "0,1\n1,2\n", ":1:1", ["#1"]),
        ("time=#1,gyro=#3", "0,1\n1,2\n", ":1:1", ["#3", "2"]),
        ("time=t,gyro=g", "t,g\n0,1\n1,2,3\n", ":3:1", ["3 fields", "2"]),
        ("time=t,gyro=g", "t,x,g\n0,0,1\n1,0,1\n2,0", ":4:1", ["2 fields", "cut off"]),
        ("time=t,gyro=g", "t,g\n0,1\n\n# x\n1,fast\n", ":5:3", ["'fast'", "'gyro'"]),
        ("time=t,gyro=g", "t;g\n0;1\n1;0,5\n", ":3:3", ["'0,5'", "0.5"]),
        ("time=t,gyro=g", "t,g\n0,1\n1,1e999\n", ":3:3", ["'1e999'"]),
        ("time=t,gyro=g", "t,g\n0,0e-320\n1,-0.5e-320\n", ":3:3", ["'-0.5e-320'"]),
        ("time=t,gyro=g", "t,g\n0,1\n1,1E-400\n", ":3:3", ["'1E-400'"]),
        ("time=t,gyro=g", "t,g\n0,1\n1,\n", ":3:3", ["no value"]),
        ("time=t,gyro=g", "t,g\n0,1\n1,180\n", ":3:3", ["180", "0.0174533"]),
        ("time=t,left=l,right=r", "t,l,r\n0,0,0\n1,90,90\n", ":3:3", ["'left'", "90", "/255"]),
        ("time=t,gyro=g", "t,g\n5,1\n5,1\n", ":3:1", ["time"]),
        ("time=t,gyro=g", "t,g\n5,1\n6,1\n99,1\n", ":4:1", ["93 ms", "cut it"]),
    ],
)
def test_what_is_wrong_with_a_log_has_a_place(tmp_path, columns, text, place, words):
    path = written(tmp_path, text)
    with pytest.raises(labmouse.Error) as error:
        fit.read_log(path, columns)
    assert str(error.value).startswith(f"{path}{place}: error: ")
    assert "\n" not in str(error.value)
    assert [word for word in words if word not in str(error.value)] == []


@pytest.mark.parametrize(
    "columns, period, words",
    [
        ("tme=ms", 0.0, ["'tme'", "'time'"]),
        ("time=a,speedometer=3", 0.0, ["'speedometer'"]),
        ("time=", 0.0, ["time=NAME"]),
        ("time=a,time=b", 0.0, ["twice"]),
        ("time=a,left=b", 0.0, ["'right'"]),
        ("time=a,left_count=b,right_count=c,left_speed=d,right_speed=e", 0.0, ["left_count", "left_speed"]),
        ("gyro=g", 0.0, ["--period"]),
        ("time=a,gyro=g", 1.0, ["period"]),
        ("time=a,gyro=g/0", 0.0, ["factor"]),
        ("time=a,gyro=g%360", 0.0, ["counter"]),
        ("time=a,left_count=b%1,right_count=c", 0.0, ["65536"]),
    ],
)
def test_what_is_wrong_with_columns_is_named(columns, period, words):
    with pytest.raises(labmouse.Error) as error:
        fit.read_log("none.csv", columns, period=period)
    assert [word for word in words if word not in str(error.value)] == []


#: The turns that the author of kerise-v4 published in 2021.
PUBLISHED = """# turns of a half-size robot
turn  speed    x        y    before
S90   265.749  44       44   1
45    411.636  72.426   30   2.574
90    422.783  70       70   20
135   353.609  33.137   80   21.863
180   412.228  0        90   24
V90   289.908  48       48   15.640
K90   754.969  125      125  2.279
"""


def test_published_turns_give_the_published_limits(tmp_path):
    path = tmp_path / "turns.txt"
    path.write_text(PUBLISHED)
    result = fit.robot_of_turns(fit.read_turns(path), "kerise")
    found = result.fits[0]
    assert found.limits[1:] == pytest.approx((113.097, 9.42478, 3769.91), rel=0.01)
    assert found.reached == (False, True, True, True)
    assert found.figures == 7
    assert max(found.errors) < 5e-4
    assert found.cell == 90.0
    assert result.warning == ""
    assert result.numbers["curve.yaw_speed"].value == found.limits[2]


def turns_within(limits, cell=180.0):
    """The turns of a robot with these limits, at given speeds."""
    turns = []
    for name, speed in (("45", 900.0), ("90", 800.0), ("135", 750.0), ("180", 700.0), ("V90", 700.0), ("S90", 500.0)):
        width, length, whole = turn_curve(name, speed, list(limits), cell)
        turns.append(fit.Turn(name, speed, 1e3 * (length + 40.0 if name == "180" else whole) / speed, width, 20.0))
    return turns


@pytest.mark.parametrize("limits", [(8000.0, 300.0, 0.0, 0.0), (8000.0, 300.0, 9.0, 0.0), (8000.0, 200.0, 9.0, 9000.0)])
def test_limits_of_turns_are_recovered_with_as_few_numbers_as_explain_them(limits):
    found = fit.fit_turns(turns_within(limits), 180.0)
    assert found.numbers == sum(limit > 0.0 for limit in limits)
    assert max(found.errors) < 5e-4
    for limit, value, reached in zip(limits, found.limits, found.reached):
        assert value == pytest.approx(limit, rel=0.002) if reached else value <= 1.02 * limit or not limit


def test_a_limit_that_no_turn_reaches_has_its_lowest_value():
    found = fit.fit_turns(turns_within((20_000.0, 300.0, 9.0, 0.0)), 180.0)
    # The fastest turn needs a lateral acceleration of 900 mm/s * 9 rad/s = 8100 mm/s².
    assert found.reached == (False, True, True, False)
    assert found.limits[0] == pytest.approx(8150.0, abs=60.0)


def test_a_wrong_figure_of_a_turn_stands_out():
    turns = turns_within((8000.0, 300.0, 0.0, 0.0))
    turns[1] = dataclasses.replace(turns[1], y=1.2 * turns[1].y)
    result = fit.robot_of_turns(turns, "classic", 180.0)
    errors = result.fits[0].errors
    assert errors[1] > 0.12 and errors[1] > 4.0 * sorted(errors)[-2]
    assert result.warning and result.text.startswith("# ")


def test_times_alone_are_a_table_of_times(tmp_path):
    turns = [fit.Turn("45", ms=257.0), fit.Turn("S90", ms=300.0)]
    assert fit.fit_turns(turns, 180.0).figures == 0
    assert "257" in fit.robot_of_turns(turns, "mm2021").text
    for base, wrong in (("kerise", turns), ("mm2021", [fit.Turn("90", 700.0, y=110.0)])):
        with pytest.raises(labmouse.Error, match=base):
            fit.robot_of_turns(wrong, base)


@pytest.mark.parametrize(
    "text, places",
    [
        ("", [""]),
        ("turn ms\n", [""]),
        ("turn time\n", [":1:6"]),
        ("ms turn\n", [":1:1"]),
        ("turn ms ms\n", [":1:9"]),
        ("turn ms\n46 3\n", [":2:1"]),
        ("turn ms\n45 fast\n45 3 4\n", [":2:4", ":3:1"]),
        ("turn speed\n45 300\n", [":2:1"]),
        *[(f"turn ms\n45 {odd}\n", [":2:4"]) for odd in ("1e-320", "0.0001", "1e309", "1e7", "-1", "0x10", "inf")],
    ],
)
def test_what_is_wrong_with_turns_has_a_place(tmp_path, text, places):
    path = tmp_path / "t"
    path.write_text(text)
    with pytest.raises(labmouse.Error) as error:
        fit.read_turns(path)
    lines = str(error.value).split("\n")
    assert [line.startswith(f"{path}{place}: error: ") for line, place in zip(lines, places)] == [True] * len(places)


UKMARS = """
#define LED_USER 6
#define BATTERY_PIN A7
const float WHEEL_DIAMETER = 32.0f;
const float MM_PER_COUNT_LEFT = (1 - ROTATION_BIAS) * PI * WHEEL_DIAMETER / (12.0 * 20);
const float MM_PER_COUNT_RIGHT = (1 + ROTATION_BIAS) * PI * WHEEL_DIAMETER / (12.0 * 20);
#define ROTATION_BIAS 0.0025
const float MOUSE_RADIUS = 38.7;
const float FWD_KM = 475.0;  // mm/s/V
const float FWD_TM = 0.190;
const float ROT_KM = 775.0;
const int SEARCH_SPEED = 380;
const int SEARCH_ACCELERATION = 2000;
const int SEARCH_TURN_SPEED = 300;
const int OMEGA_SPIN_TURN = 360;
const int ALPHA_SPIN_TURN = 3600;
const float TOO_MUCH = 1e300;
const TurnParameters turn_params[4] = {
    {SEARCH_TURN_SPEED, 70, 80, 90.0, 287.0, 2866.0, 90},  // 0 => SS90EL
    {SEARCH_TURN_SPEED, 70, 80, -90.0, 287.0, 2866.0, 90},  // 1 => SS90ER
};
"""


def header_in(folder, text):
    path = folder / "config-robot.h"
    path.write_text(text, encoding="utf-8")
    return fit.read_header(path)


def test_the_limits_of_a_turn_of_firmware_drive_it_as_its_rates_do(tmp_path):
    result = fit.robot_of_header(header_in(tmp_path, UKMARS), "beginner")
    own = [300.0 * math.radians(287.0), math.radians(2866.0), 0.0, 0.0]
    assert turn_curve("S90", 300.0, list(result.fits[0].limits), 180.0) == pytest.approx(turn_curve("S90", 300.0, own, 180.0), rel=5e-4)
    assert result.warning == ""


def test_constants_of_firmware_are_numbers_of_the_robot_and_all_others_are_listed(tmp_path):
    header = header_in(tmp_path, UKMARS)
    text = fit.robot_of_header(header, "beginner").text
    path = tmp_path / "mine.toml"
    path.write_text(text, encoding="utf-8")
    _, numbers = fit.robot_numbers(path)
    base = fit.base_numbers("beginner")
    expected = {
        "body.half_track": 38.7,
        "motors.drive_gain": 475.0 * base["motors.volts"],
        "motors.drive_time": 190.0,
        # Full duty on both motors, one backwards, is a difference of 2.
        "motors.turn_gain": math.radians(775.0) * base["motors.volts"] / 2.0,
        "sensors.count": math.pi * 32.0 / 240.0,
        "search.speed": 380.0,
        "search.turn_speed": 300.0,
        "search.pivot_speed": 2.0 * math.pi,
        "search.pivot_acceleration": 20.0 * math.pi,
        "straight.acceleration": 2000.0,
        "straight.braking": 2000.0,
        "body.front": base["body.front"],
    }
    for key, value in expected.items():
        assert numbers[key] == pytest.approx(value, rel=1e-5), key
    assert set(header.constants) >= {"LED_USER", "WHEEL_DIAMETER", "ROTATION_BIAS", "SEARCH_SPEED", "TOO_MUCH"}
    for name in (*header.constants, "BATTERY_PIN"):
        assert name in text


def test_constants_that_fit_no_robot_are_not_used(tmp_path):
    header = header_in(tmp_path, "#define FWD_TM 190\n#define SEARCH_SPEED 300\n#define FAST_RUN_ACCELERATION 4000\n#define SEARCH_ACCELERATION 9\n")
    result = fit.robot_of_header(header, "beginner")
    assert re.search(r"^# FWD_TM = 190: .*motors.drive_time", result.text, re.MULTILINE)
    assert re.search(r"^# SEARCH_ACCELERATION = 9: ", result.text, re.MULTILINE)
    assert "\nacceleration = 4000 " in result.text
    both = fit.robot_of_header(header_in(tmp_path, "#define SEARCH_ACCELERATION 2000\n#define FAST_RUN_ACCELERATION 3000\n"), "beginner").text
    assert "\nacceleration = 3000 " in both and re.search("^# SEARCH_ACCELERATION = 2000: ", both, re.MULTILINE)
    # A robot without hardware has no place for that of the header.
    assert "MOUSE_RADIUS" in fit.robot_of_header(header_in(tmp_path, "#define MOUSE_RADIUS 38\n"), "half").text.split("\n\n")[0]
    with pytest.raises(labmouse.Error, match="kerise"):
        fit.robot_of_header(header, "kerise")


def test_turns_of_firmware_are_named_in_many_places(tmp_path):
    rows = """struct turn { float yaw_rate, speed; int offset[2]; float yaw_acceleration; };
        const struct turn SS90[] = {{300.0f, 500.0f, 0, 1000.0f}, {200.0f, 400.0f, 0, 900.0f}};
        typedef struct params { int speed; int entry_offset; int exit_offset; float angle; float omega; float alpha; } params_t;
        params_t turns[] = {
            [SD45R] = {600, -12, -0.0f, -45.0, 300., 3e3},
            {SS180, 600, 1, 2, 180.0, 320, 3e3}, {"DD90K", 900, 1, 2, 90, 310, 3e3}, /* SD135 */
            {BASE + 2 * 5, 1, 2, 135, 7 / 2 * 100, 3e3}, // SD135
        };
        static const int BASE = 590;
        int pins[] = {1, 2, 3}; enum { A, B };
        void run() { if (1) { go(1, 2); } }
    """
    header = header_in(tmp_path, rows)
    found = {turn.name: (turn.speed, turn.yaw_speed, turn.yaw_acceleration) for turn in header.turns}
    degrees = {"90": (500, 300, 1000), "45": (600, 300, 3000), "180": (600, 320, 3000), "K90": (900, 310, 3000), "135": (600, 300, 3000)}
    assert found == {name: pytest.approx((speed, math.radians(rate), math.radians(gain))) for name, (speed, rate, gain) in degrees.items()}
    notes = "\n".join(header.notes)
    assert "SS90" in notes and "fastest of 2" in notes
    assert "-12 and 0 mm" in notes
    assert "line 10: pins" in notes and "line 11" not in notes
    assert {turn.name for turn in fit.read_turns(tmp_path / "config-robot.h")} == set(found)


def sine_end(speed, omega, alpha, angle):
    """Where a curve with sine ramps ends, whose highest yaw acceleration is alpha; all in rad."""
    ramp = math.pi * omega / (2.0 * alpha)
    whole, steps = 2.0 * ramp + (angle - omega * ramp) / omega, 100_000
    heading, ahead, aside = 0.0, 0.0, 0.0
    for step in range(steps):
        time = (step + 0.5) * whole / steps
        near = min(time, whole - time, ramp)
        heading += omega * (1.0 - math.cos(math.pi * near / ramp)) / 2.0 * whole / steps
        ahead, aside = ahead + speed * math.cos(heading) * whole / steps, aside + speed * math.sin(heading) * whole / steps
    return ahead, aside, heading, whole


@pytest.mark.parametrize("row", ["{500, 0, 0, 90.0, 287.0, 2000.0}, // SS90 sinusoidal", "{500, 0, 0, 90.0, 287.0, 2000.0, SINE}, // SS90"])
def test_sine_ramps_become_steady_ones_of_the_same_angle_and_time(tmp_path, row):
    members = "int speed; int entry_offset; int exit_offset; float angle, omega, alpha; int profile;"
    header = header_in(tmp_path, f"struct P {{ {members} }};\nconst P turns[] = {{\n{row}\n}};\n")
    (turn,) = header.turns
    ahead, aside, heading, whole = sine_end(500.0, math.radians(287.0), math.radians(2000.0), math.pi / 2.0)
    assert heading == pytest.approx(math.pi / 2.0, abs=1e-3)
    width, length, _ = turn_curve("90", 500.0, [500.0 * turn.yaw_speed, turn.yaw_acceleration, 0.0, 0.0], 180.0)
    assert length / 500.0 == pytest.approx(whole, rel=2e-4)
    stated = float(re.search(r"ends ([0-9.]+) mm", "\n".join(header.notes))[1])
    # The path of a turn to the side is as long ahead as aside.
    assert stated == pytest.approx(math.dist((width, width), (ahead, aside)), abs=0.02)
    assert stated > 0.5


@pytest.mark.parametrize(
    "text, place",
    [
        ("const P t[] = {\n  {FAST, 1, 2, 90, 287, 2866, 0}, // SS90\n};", ":2:4"),
        ("const P t[] = {\n  {300, 1, 2, 45, 287, 2866, 0}, // SS90\n};", ":2:3"),
        ("const P t[] = {\n  {300, 1, 2, 90, 287}, // SS90\n};", ":2:3"),
        ("const P t[] = {\n  {300, 1, 2, 90, 0, 2866, 0}, // SS90\n};", ":2:19"),
        ("const P t[] = {\n  {-300, 1, 2, 90, 287, 2866, 0}, // SS90\n};", ":2:4"),
        ("const P t[] = {\n  {300, 1 ? 2 : 3, 2, 90, 287, 2866, 0}, // SS90\n};", ":2:9"),
        ("const P t[] = {\n  {300, 1, 2, 90, 287, 2866, 0},\n};", ""),
        ("const char* name = \"x\";", ""),
    ],
)
def test_what_is_wrong_with_a_header_has_a_place(tmp_path, text, place):
    with pytest.raises(labmouse.Error) as error:
        header_in(tmp_path, text)
    assert str(error.value).startswith(f"{tmp_path / 'config-robot.h'}{place}: error: ")


def test_tables_have_negative_zeros_negative_straights_and_names_of_firmware(tmp_path):
    path = tmp_path / "turns.txt"
    path.write_text("turn speed x y before after\nSS90E 300 92 92 -2 -0.0\n90 500 120 120 -0.0 -0\n")
    turns = fit.read_turns(path)
    assert [(turn.name, turn.y, turn.before) for turn in turns] == [("S90", 92.0, -2.0), ("90", 120.0, 0.0)]
    assert fit.cell_of(turns) == 180.0
    path.write_text("turn speed y\n90 -500 120\n90 500 -120\n")
    with pytest.raises(labmouse.Error) as error:
        fit.read_turns(path)
    assert [line.split(": ")[0] for line in str(error.value).split("\n")] == [f"{path}:2:4", f"{path}:3:8"]


def test_a_robot_beside_its_own_log_does_not_part_and_a_weak_one_does(driven, tmp_path):
    log = fit.read_log(driven, DUTIES)
    same = fit.compare_log(log, "kerise")
    assert abs(same.stronger) < 0.05
    assert same.by_duties and list(same.curves) == ["speed", "yaw", "way", "turn"]
    assert same.curves["way"].parts is None
    base, text = fit.base_numbers("kerise"), fit.robot_of_logs([], "kerise").text
    weak = tmp_path / "weak.toml"
    weak.write_text(text.replace(f"drive_gain = {base['motors.drive_gain']:g}", "drive_gain = 2600"), encoding="utf-8")
    other = fit.compare_log(log, str(weak))
    assert other.curves["speed"].parts and other.curves["turn"].parts == same.curves["turn"].parts
    assert other.table().loc["way mm", "rms off"] > 10.0 * same.table().loc["way mm", "rms off"]
    followed = fit.compare_log(fit.read_log(driven, "time,left_count,right_count,gyro*0.00107"), "kerise")
    assert not followed.by_duties and followed.table().loc["way mm", "most off"] < 5.0


def test_what_cannot_be_compared_is_refused(tmp_path):
    moving = "t,l\n" + "".join(f"{t},{2000 * t}\n" for t in range(50))
    for text, columns in (("t\n0\n1\n", "time=t"), ("t,g\n0,0\n1,0\n", "time=t,gyro=g"), (moving, "time=t,left_count=l,right_count=l")):
        with pytest.raises(labmouse.Error, match="log.csv: error: "):
            fit.compare_log(fit.read_log(written(tmp_path, text), columns), "kerise")


def test_the_commands_write_files_and_pictures(driven, tmp_path, capsys):
    robot, picture = tmp_path / "mine.toml", tmp_path / "fit.svg"
    assert fit_command([driven, "--base", "kerise", "--columns", DRIVEN, "--out", str(robot), "--plot", str(picture)]) == 0
    assert picture.read_text(encoding="utf-8").count("<svg") == 1
    assert "drive_gain" in robot.read_text(encoding="utf-8")
    assert compare([driven, "--robot", str(robot), "--columns", DUTIES, "--svg", str(tmp_path / "both.svg")]) == 0
    out, err = capsys.readouterr()
    assert err == "" and "way mm" in out
    assert (tmp_path / "both.svg").exists()


@pytest.mark.parametrize(
    "words, code",
    [
        ([], 2),
        (["--log", "none.csv", "--columns", "time,gyro"], 2),
        (["--log", "none.csv"], 2),
        (["--turns", "none.txt"], 2),
        (["--turns", "a", "--log", "b"], 2),
        (["--log", "none.csv", "--columns", "time,gyro", "--base", "half"], 2),
    ],
)
def test_errors_of_users_are_one_line(words, code, capsys):
    assert fit_command(words) == code
    out, err = capsys.readouterr()
    assert out == "" and err.count("\n") == 1 and "error: " in err


def test_outputs_overwrite_no_input(tmp_path, capsys):
    path = written(tmp_path, "t,g\n0,0\n1,0\n")
    for out in (["--out", str(path)], ["--plot", str(path)], ["--out", "x.toml", "--plot", "./x.toml"]):
        assert fit_command([str(path), "--base", "kerise", "--columns", "time=t,gyro=g", *out]) == 2
    assert path.read_text() == "t,g\n0,0\n1,0\n"


def test_outputs_overwrite_no_base_and_no_file_of_another_kind(driven, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    base, mouse = tmp_path / "base.toml", tmp_path / "mouse.py"
    base.write_text(subprocess.run(["labmouse", "robot", "show", "kerise"], capture_output=True, text=True, check=True).stdout)
    mouse.write_text("# mine\n")
    before = base.read_text(encoding="utf-8")
    for words in (["--base", "base.toml", "--out", "./base.toml"], ["--base", "kerise", "--out", "mouse.py"],
                  ["--base", "base.toml", "--out", "mine.toml", "--plot", "base.toml"]):
        assert fit_command([driven, "--columns", DRIVEN, *words]) == 2
    assert (base.read_text(encoding="utf-8"), mouse.read_text()) == (before, "# mine\n")
    # The name of a built-in robot is no file.
    assert fit_command([driven, "--columns", DRIVEN, "--base", "kerise", "--out", "kerise"]) == 0


def test_what_a_log_should_tell_and_does_not_is_an_exit_code(tmp_path, capsys):
    path = written(tmp_path, "t,g\n" + "".join(f"{t},0\n" for t in range(200)))
    assert fit_command([str(path), "--base", "kerise", "--columns", "time=t,gyro=g"]) == 1
    assert str(path) in capsys.readouterr().err


def test_without_scipy_the_package_says_how_to_get_it():
    program = "import sys, importlib.util as u; find = u.find_spec; u.find_spec = lambda n, *a: None if n == 'scipy' else find(n, *a); import labmouse.fit"
    ran = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False, env=dict(os.environ))
    assert ran.returncode != 0
    assert "pip install -v '.[fit]' in the source folder" in ran.stderr


def test_the_package_needs_neither_scipy_nor_matplotlib():
    program = "import sys, labmouse; print([name for name in ('scipy', 'matplotlib', 'labmouse.fit') if name in sys.modules])"
    assert subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout == "[]\n"


def test_the_page_names_the_roles_and_units_of_columns():
    page = Path(__file__).parents[2] / "docs" / "how-to" / "robot-from-a-log.md"
    rows = [re.match(r"\| `(\w+)` \| ([^|]*) \|", line) for line in page.read_text(encoding="utf-8").split("\n")]
    assert {row[1]: row[2].strip() for row in rows if row} == {name: role.unit for name, role in ROLES.items()}


def test_files_without_an_end_are_refused(tmp_path):
    with pytest.raises(labmouse.Error, match="MiB"):
        fit.read_log("/dev/zero", "time,gyro")
    with pytest.raises(labmouse.Error, match="MiB"):
        fit.read_turns("/dev/zero")
    long = tmp_path / "long.txt"
    long.write_text("turn ms\n" + "90 370\n" * 200_000)
    with pytest.raises(labmouse.Error, match="MiB"):
        fit.read_turns(long)
    for folder in (tmp_path, tmp_path / "none"):
        with pytest.raises(labmouse.Error, match=str(folder)):
            fit.read_turns(folder)
        with pytest.raises(labmouse.Error, match=str(folder)):
            fit.read_log(folder, "time,gyro")


_NEAR_CSV = st.text(st.sampled_from("0123456789.-+eE,;\t \n\r\"'#xnaif\x00\x1a\ufeff\u00e9"), max_size=200)


@given(text=_NEAR_CSV, named=st.booleans())
@settings(deadline=None, max_examples=300)
def test_any_text_is_a_log_or_refused(text, named):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "log.csv"
        path.write_text(("a,b\n" if named else "") + text, encoding="utf-8", newline="")
        for columns in ("left=#1,right=#2", "time=#1,gyro=#2"):
            try:
                log = fit.read_log(path, columns, period=0.0 if "time" in columns else 1.0)
            except labmouse.Error as error:
                assert str(error).startswith(f"{path}:") and "\n" not in str(error)
            else:
                assert len(log.times) >= 2 and np.isfinite(log.times).all()


@given(text=_NEAR_CSV, turn=st.sampled_from(["", "S90 265.749 44 1\n", "90 "]))
@settings(deadline=None, max_examples=300)
def test_any_text_is_a_table_of_turns_or_refused(text, turn):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "turns.txt"
        path.write_text("turn speed y before\n" + turn + text, encoding="utf-8", newline="")
        try:
            turns = fit.read_turns(path)
        except labmouse.Error as error:
            assert all(line.startswith(f"{path}:") for line in str(error).split("\n"))
        else:
            assert turns and all(math.isfinite(one.speed) for one in turns)


_NEAR_C = st.lists(
    st.sampled_from([*"{}[]();,=+-*/.\n\"", " ", "const ", "float ", "#define ", "struct ", "A", "B", " SS90", "// SS90E\n", "sine", "300", "-0.0f", "90", "1e9", "/*", "*/"]),
    max_size=60,
).map("".join)


@example(text="{,} SS90", row="")
@given(text=_NEAR_C, row=st.sampled_from(["", "P t[] = {{300, 1, 2, 90, 287, 2866, 0},  // SS90\n", "const float A = "]))
@settings(deadline=None, max_examples=300)
def test_any_text_is_a_header_or_refused(text, row):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "robot.h"
        path.write_text(row + text, encoding="utf-8", newline="")
        try:
            header = fit.read_header(path)
        except labmouse.Error as error:
            assert all(line.startswith(f"{path}:") for line in str(error).split("\n"))
        else:
            assert header.turns or header.constants
            assert all(math.isfinite(value) for value in header.constants.values())


@pytest.mark.parametrize("part", ["/*", "const ", "const A = ", "{1,2},", "P t[", "a", "struct s {int a[", "#define A B\n", "{1, 2, 3, 4, 5, 6, 7}, // x\n", "(", "-1"])
def test_no_long_header_hangs(tmp_path, part):
    text = "#define A 1\nP t[] = {{300, 1, 2, 90, 287, 2866, 0},  // SS90\n" + part * (500_000 // len(part))
    assert header_in(tmp_path, text).turns
