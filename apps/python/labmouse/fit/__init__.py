"""Identifies robots from logs of a real mouse or from measured turns: docs/how-to/robot-from-a-log.md has the method.

Needs SciPy, and matplotlib for plots: run `pip install -v '.[fit]'` in the source folder of labmouse.

    log = read_log("run.csv", "time=ms,left=pwm_l/255,right=pwm_r/255,left_count=enc_l,right_count=enc_r,gyro=gz*0.00107")
    fit = fit_log(log, base_numbers("kerise"))
    print(fit.drive.gain, robot_of_logs([fit], "kerise").text)
"""

from importlib.util import find_spec

if find_spec("scipy") is None:
    raise ImportError("labmouse.fit needs SciPy: run pip install -v '.[fit]' in the source folder of labmouse")

from ._comparison import Comparison, compare_log
from ._counts import CountFit, fit_count
from ._estimates import Estimate
from ._gyro import GyroFit, fit_gyro
from ._headers import Header
from ._infrared import InfraredFit, fit_infrared
from ._log_fit import LogFit, fit_log, pooled
from ._logs import Log, read_log
from ._motion import Motion, motion_of
from ._motors import MotorFit
from ._plots import plot, save_plot
from ._robots import FittedRobot, base_numbers, cell_of, robot_numbers, robot_of_header, robot_of_logs, robot_of_turns
from ._turn import Turn
from ._turns import TurnFit, fit_turns, read_header, read_turns

__all__ = [
    "Comparison",
    "CountFit",
    "Estimate",
    "FittedRobot",
    "GyroFit",
    "Header",
    "InfraredFit",
    "Log",
    "LogFit",
    "Motion",
    "MotorFit",
    "Turn",
    "TurnFit",
    "base_numbers",
    "cell_of",
    "compare_log",
    "fit_count",
    "fit_gyro",
    "fit_infrared",
    "fit_log",
    "fit_turns",
    "motion_of",
    "plot",
    "pooled",
    "read_log",
    "read_header",
    "read_turns",
    "robot_numbers",
    "robot_of_header",
    "robot_of_logs",
    "robot_of_turns",
    "save_plot",
]
