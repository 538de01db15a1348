"""The estimator of a controller for labmouse: dead reckoning by encoders and gyro. labmouse does the rest:

    labmouse race --world physical --mice 'flood-return:parts=python3 templates/estimator.py'

docs/reference/protocols.md explains the lines that it reads and writes. The error of its position grows without limit,
as nothing corrects it: the infrared sensors could.
"""
import sys

TICK = 0.001  # s


def turned(ahead, angle):
    """Turns a direction, a complex number of length 1, to the left by a small angle: by basic arithmetic alone, so that
    it gives the same bits everywhere."""
    square = angle * angle
    ahead *= complex(1 - square / 2 * (1 - square / 12 * (1 - square / 30)),
                     angle * (1 - square / 6 * (1 - square / 20 * (1 - square / 42))))
    length = (3 - ahead.imag * ahead.imag - ahead.real * ahead.real) / 2
    return complex(ahead.real * length, ahead.imag * length)


class Estimator:
    def __init__(self, told):
        self.count, self.gyro_step = told["sensors.count"], told["sensors.gyro_step"]
        self.counts = self.tick = None  # of the encoders, at the last tick; the ms since the mouse was switched on

    def put(self, x, y, cosine, sine):
        """The mouse was put down at about this place, in mm, in that direction."""
        self.x, self.y, self.ahead = x, y, complex(cosine, sine)

    def estimate(self, sense):
        """The estimate after a tick, from its first four readings: tick, counts and gyro."""
        counts = sense[1] + sense[2]
        way = 0.5 * (0 if self.counts is None else counts - self.counts) * self.count
        seconds = TICK if self.tick is None else (sense[0] - self.tick) * TICK
        self.counts, self.tick = counts, sense[0]
        turning = sense[3] * self.gyro_step
        went = turned(self.ahead, turning * seconds / 2)
        self.x += way * went.real
        self.y += way * went.imag
        self.ahead = turned(self.ahead, turning * seconds)
        # Slip angle, speed and turn rate; then the covariance: a deviation of 1 mm in x and in y, and of a degree.
        rest = 0, way / seconds, turning, 1, 0, 0, 1, 0, 3e-4
        return " ".join(map(repr, (self.x, self.y, self.ahead.real, self.ahead.imag, *rest)))


told, estimator = {}, None
for line in sys.stdin:
    word, *rest = line.split()
    if word == "estimate":  # then the readings, and 8 numbers of the target, most of which it does not need
        print("estimate", estimator.estimate(list(map(int, rest[:4]))), flush=True)
    elif word == "put":
        estimator.put(*map(float, rest))
    elif word == "begin":
        if "sensors.gyro_step" not in told:
            sys.exit("estimator.py needs a robot with a gyro")
        estimator = Estimator(told)
        print("labmouse pilot 1 estimator", flush=True)
    elif len(rest) == 1 and rest[0][0] in "-0123456789":
        told[word] = float(rest[0])
