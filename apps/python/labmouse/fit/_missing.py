"""What logs do not determine, and the experiments that would."""

from typing import Sequence

from ._estimates import Estimate
from ._log_fit import LogFit

_STEPS = "log the duties while it drives straight: half duty for 0.5 s, a quarter for 0.5 s, then 0 until it stands; repeat it six times"
_SPINS = "log the duties while it spins: left -0.3 and right 0.3 for 0.5 s, half of that for 0.5 s, then 0 until it stands; repeat it to both sides"
#: By part: the keys of robot files, and the experiment that gives them.
_EXPERIMENTS = (
    ("encoders", ("sensors.count",), "drive a measured distance straight on and give it by --way MM"),
    ("driving", ("motors.drive_gain", "motors.drive_time", "motors.drive_dead_zone"), _STEPS),
    ("turning", ("motors.turn_gain", "motors.turn_time", "motors.turn_dead_zone"), _SPINS),
    ("effect of turning on driving", ("motors.turning",), "log the duties while it drives curves at a steady speed"),
    ("gyro", ("noise.gyro",), "log the gyro for a second at rest, with the motors off"),
    (
        "infrared",
        ("sensors.infrared_gain", "sensors.infrared_fall"),
        "log the readings at twelve measured distances from a wall, 0.1 s each, with the distances in wall_left, wall_right or wall_ahead",
    ),
)


def missing(fits: Sequence[LogFit], numbers: dict[str, Estimate]) -> list[str]:
    """One line for each part that the logs do not determine reliably: its keys, and the experiment to make."""
    lines = []
    for part, keys, experiment in _EXPERIMENTS:
        if part == "encoders" and not any("left_count" in fit.log for fit in fits):
            continue  # the log has distances, so there are no counts to calibrate
        lacking = [key for key in keys if key not in numbers or not numbers[key].sure]
        if lacking:
            lines.append(f"{', '.join(lacking)}: {experiment}")
    return lines
