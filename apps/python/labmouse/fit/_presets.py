"""Formats of logs that are known by their names or by their first line."""

from typing import Optional

from .. import Error

#: The names of report_profile() of UKMARS mazerunner-core, in small letters; `time` is named but not printed.
_UKMARS = ("robotpos", "robotangle", "fwdpos", "fwdspeed", "rotpos", "rotspeed", "fwdmvolts", "rotmvolts")
_UKMARS_PERIOD = 10.0
#: Columns of a log of the controller of micromouse-kerise-v4: reference and estimate of speed and acceleration, then the
#: parts of the duty, first of driving, then of turning.
_KERISE = tuple(
    f"{what}.{axis}" for axis in ("tra", "rot") for what in ("ref_v", "est_v", "ref_a", "est_a", "ff", "fbp", "fbi", "fbd")
)
_KERISE_PERIOD = 1.0

PRESETS = ("ukmars", "kerise")


def prepared(path: str, text: str, preset: str) -> tuple[str, str, float]:
    """A log with the faults of its format repaired, its `--columns`, and its period in ms. preset: the format; '': that
    of the first line, if it is known. Other logs are unchanged, and have no columns. Lines keep their numbers."""
    if preset and preset not in PRESETS:
        raise Error(f"--preset: '{preset}' is no known format; they are {', '.join(PRESETS)}")
    lines = text.split("\n")
    used = [i for i, line in enumerate(lines) if line.strip() and not line.startswith("#")]
    if not used:
        return text, "", 0.0
    first = _fields(lines[used[0]])
    if preset != "kerise" and (columns := _ukmars(first, preset)):
        if first[0].lower() == "time" and len(used) > 1 and len(_fields(lines[used[1]])) == len(first) - 1:
            at = lines[used[0]].lower().index("time")
            lines[used[0]] = lines[used[0]][:at] + "    " + lines[used[0]][at + 4 :]
            columns = _ukmars(first[1:], preset)
        return _without_repetitions(lines, used if _is_number(first[0]) else used[1:]), columns, _UKMARS_PERIOD
    if preset != "ukmars" and (columns := _kerise(first, preset)):
        return text, columns, _KERISE_PERIOD
    if preset:
        names = _UKMARS if preset == "ukmars" else _KERISE
        raise Error(f"{path}: error: is no log of {preset}: it should have {len(names)} columns without names, or the names {', '.join(names)}")
    return text, "", 0.0


def _fields(line: str) -> list[str]:
    separator = next((one for one in ",;\t" if one in line), None)
    return [one.strip(' \t\r"') for one in line.split(separator) if one.strip() or separator in (",", ";")]


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def _places(names: "tuple[str, ...]", first: list[str], least: int) -> Optional[dict[str, str]]:
    """The numbers of the columns of these names, as in '#3'; None if one is missing. least: the number of columns that a
    log without names must have; 0: it must have names."""
    found = [one.lower() for one in first]
    if least and all(map(_is_number, first)) and len(first) >= least:
        found = list(names)
    return {name: f"#{found.index(name) + 1}" for name in names} if all(name in found for name in names) else None


def _ukmars(first: list[str], preset: str) -> str:
    place = _places(_UKMARS, first, len(_UKMARS) if preset and len(first) == len(_UKMARS) else 0)
    if place is None:
        return ""
    time = f"time=#{[one.lower() for one in first].index('time') + 1}," if "time" in map(str.lower, first) else ""
    return (
        f"{time}travel={place['robotpos']},heading={place['robotangle']},speed={place['fwdspeed']},turning={place['rotspeed']}*0.0174532925,"
        f"forward_volts={place['fwdmvolts']}/1000,rotation_volts={place['rotmvolts']}/1000"
    )


def _kerise(first: list[str], preset: str) -> str:
    plain = [one.replace("sc->", "").replace("sc.", "") for one in first]
    place = _places(_KERISE, plain, len(_KERISE) if preset else 0)
    if place is None:
        return ""
    along, around = ("+".join(place[f"{part}.{axis}"] for part in ("ff", "fbp", "fbi", "fbd")) for axis in ("tra", "rot"))
    return (
        f"left={along}-({around})/2,right={along}+({around})/2,forward_speed={place['est_v.tra']},rotation_speed={place['est_v.rot']},"
        f"speed={place['ref_v.tra']},turning={place['ref_v.rot']}"
    )


def _without_repetitions(lines: list[str], rows: list[int]) -> str:
    """A log of report_profile without the repetitions of its first row, which is printed until the profile starts."""
    for row, after in zip(rows, rows[1:]):
        if lines[row].split() != lines[after].split():
            break
        lines[row] = "#"
    return "\n".join(lines)
