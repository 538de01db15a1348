"""A turn of a robot, as tables have it."""

from dataclasses import dataclass

TURNS = ("45", "90", "135", "180", "V90", "S90", "K90")


@dataclass(frozen=True)
class Turn:
    """A turn; a value that the table does not have is 0."""

    name: str  #: of TURNS; K90 is V90 in cells of twice the size
    speed: float = 0.0  #: mm/s, constant
    ms: float = 0.0  #: time of the whole turn in ms, from node to node
    y: float = 0.0  #: lateral distance in mm between both ends of the curve, in the frame of its beginning
    before: float = 0.0  #: length in mm of the straight before the curve; below 0, the curve begins before the node
    yaw_speed: float = 0.0  #: highest yaw rate in the curve, rad/s
    yaw_acceleration: float = 0.0  #: steady, in the ramps before and after the arc, rad/s²
