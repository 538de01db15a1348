"""A controller for labmouse: the whole program of a mouse, from sensor readings to motor duties.

It floods to the goal, drives home, and then makes speed runs, faster over known cells. It stops to turn.
Side walls correct its lateral position; the ends of side walls, and walls ahead, correct its longitudinal position.
docs/reference/protocols.md explains the lines that it reads and writes.
"""
import math
import sys

BATCH = 8  # ms from one answer to the next; each answer has duties for as many
STEP = BATCH / 1000  # the same in s
WAYS = (0, 1), (1, 0), (0, -1), (-1, 0)  # to the north, east, south, west: headings 0 to 3


def next_to(cell, way):
    return cell[0] + WAYS[way][0], cell[1] + WAYS[way][1]


class Controller:
    def __init__(self, told):
        self.told, self.side = told, told["cell"]  # size of a cell, mm
        self.search_speed, self.fast_speed = 3 * self.side, 6 * self.side  # mm/s
        self.rate = min(40 * self.side, 0.4 * told["body.grip"])  # mm/s²
        # Distance ahead of the axle where the side sensors see; lateral distance for 1/e of a reading (both mm).
        angle, face = told["sensors.side_angle"], self.side / 2 - self.side / 30
        self.spot = told["sensors.side_ahead"] + (face - told["sensors.side_aside"]) / math.tan(angle)
        self.fall = told["sensors.infrared_fall"] * math.sin(angle)
        self.is_open = {}  # known walls, by cell and direction
        self.seen = set()  # cells whose walls were read
        self.counts = None
        self.put_at_start()

    def put_at_start(self):
        self.cell, self.heading = self.told["start"]
        self.x, self.y = self.middle()  # mm
        self.angle = math.pi / 2 * (1 - self.heading)  # rad, to the left of east
        self.speed = self.turning = self.wanted_speed = self.wanted_turning = 0.0  # mm/s, rad/s
        self.beside = [None, None]  # whether there is a wall to the left, and to the right
        self.word, self.work = "drive", self.runs()

    # Position: east and north of the maze's corner, and along and left of its way, in mm.

    def middle(self):
        return (self.cell[0] + 0.5) * self.side, (self.cell[1] + 0.5) * self.side

    def along(self, point=None):
        x, y = point or (self.x, self.y)
        return x * WAYS[self.heading][0] + y * WAYS[self.heading][1]

    def aside(self):  # to the left
        (x, y), (east, north) = self.middle(), WAYS[self.heading]
        return (self.y - y) * east - (self.x - x) * north

    def off_heading(self):  # to the left
        off = self.angle - math.pi / 2 * (1 - self.heading)
        return (off + math.pi) % (2 * math.pi) - math.pi

    def shift(self, along, aside):
        east, north = WAYS[self.heading]
        self.x += along * east - aside * north
        self.y += along * north + aside * east

    # Estimation from the sensors.

    def read(self, ticks):
        """Updates the estimate by the readings of some ticks of 1 ms, each as 13 numbers."""
        last, seconds = ticks[-1], len(ticks) / 1000
        counts = last[1] + last[2]
        way = 0.0 if self.counts is None else (counts - self.counts) / 2 * self.told["sensors.count"]
        turn = sum(tick[3] for tick in ticks) / 1000 * self.told["sensors.gyro_step"]
        self.counts, self.turning = counts, turn / seconds
        self.speed += 0.6 * (way / seconds - self.speed)
        self.x += way * math.cos(self.angle + turn / 2)
        self.y += way * math.sin(self.angle + turn / 2)
        self.angle += turn
        self.levels = [sum(tick[beam] for tick in ticks) / len(ticks) for beam in (8, 6)]  # left, right
        self.range, self.volts = last[10], last[12] / 1000
        if abs(self.off_heading()) < 0.2 and self.speed > 0.3 * self.search_speed:
            self.keep_to_walls(len(ticks), any(tick[11] for tick in ticks))

    def keep_to_walls(self, ticks, range_new):
        place = (self.along() + self.spot) / self.side  # of the side beams' spots, in cells
        line = round(place)
        for side, sign in (0, 1), (1, -1):
            before, now = self.beside[side], self.is_wall(side)
            if now and abs(place - line) > 0.25:
                level = self.levels[side] / self.told["sensors.infrared_gain"]
                off = sign * self.fall * math.log(level) - self.aside()
                self.shift(0, 0.02 * ticks * off)
                self.angle += 0.005 * ticks * off / self.side
            elif now != before and before is not None:
                # Walls end half a post behind a grid line, and begin half a post before one.
                self.shift(0.3 * (line + (1 if before else -1) / 30 - place) * self.side, 0)
            self.beside[side] = now
        face = (self.along() + self.told["sensors.ranger_ahead"] + self.range) / self.side + 1 / 30
        if range_new and 0 < self.range < 1.2 * self.side and abs(face - round(face)) < 0.2:
            self.shift(0.1 * (round(face) - face) * self.side, 0)

    def is_wall(self, side):
        return self.levels[side] > 0.3 * self.told["sensors.infrared_gain"]

    def look(self):
        """Records the walls of the cell that it enters or stands in."""
        to_wall = self.along(self.middle()) - self.along() + self.side / 2 - self.told["sensors.ranger_ahead"]
        ahead = 0 < self.range < to_wall + 0.4 * self.side
        for turn, wall in (-1, self.is_wall(0)), (0, ahead), (1, self.is_wall(1)):
            way = (self.heading + turn) % 4
            self.is_open.setdefault((self.cell, way), not wall)
            self.is_open.setdefault((next_to(self.cell, way), (way + 2) % 4), not wall)
        self.seen.add(self.cell)

    # Route planning.

    def way_to(self, targets, unseen):
        """First direction of a shortest way; prefers straight on. `unseen`: whether unseen walls count as open."""
        left, queue = {target: 0 for target in targets}, list(targets)
        for cell in queue:
            for way in range(4):
                other = next_to(cell, way)
                if other not in left and self.leads(cell, way, unseen):
                    left[other] = left[cell] + 1
                    queue.append(other)
        for turn in 0, 1, 3, 2:
            way = (self.heading + turn) % 4
            if left.get(next_to(self.cell, way)) == left.get(self.cell, 0) - 1 and self.leads(self.cell, way, unseen):
                return way
        # No route left: it clears its map.
        self.is_open.clear()
        self.seen.clear()
        return self.way_to(targets, True)

    def leads(self, cell, way, unseen):
        (x, y), (width, height) = next_to(cell, way), self.told["size"]
        return 0 <= x < width and 0 <= y < height and self.is_open.get((cell, way), unseen)

    # Motion control: these yield for each step the speed (mm/s), acceleration (mm/s²) and turn rate (rad/s).

    def straight(self, end, most):
        """A step towards coordinate `end` along the way, at most at speed `most`, and slow enough to stop there."""
        left = max(0.0, end - self.along())
        speed = min(self.wanted_speed + self.rate * STEP, most, math.sqrt(2 * self.rate * left))
        rate, self.wanted_speed = (speed - self.wanted_speed) / STEP, speed
        bend = 2.5 / self.side  # how fast the lateral error decays, 1/mm
        return speed, rate, -max(speed, self.side) * bend * (bend * self.aside() + 1.6 * self.off_heading())

    def rest(self, seconds):
        self.wanted_speed = 0.0
        for _ in range(round(seconds / STEP)):
            yield 0.0, 0.0, -8 * self.off_heading()

    def pivot(self, heading):
        self.heading, self.beside, speed = heading, [None, None], 0.0
        most, rate = 9.0, 90.0  # rad/s, rad/s²
        while abs(self.off_heading()) > 0.02 or abs(self.turning) > 0.3:
            off = -self.off_heading()
            speed = min(speed + rate * STEP, most, math.sqrt(1.4 * rate * abs(off)))
            yield 0.0, 0.0, math.copysign(speed, off) if abs(off) > 0.02 else 8 * off
        yield from self.rest(0.05)

    def go(self, targets, unseen, most):
        """Drives to one of these cells."""
        while self.cell not in targets:
            way = self.way_to(targets, unseen)
            if way != self.heading:
                yield from self.pivot(way)
            while self.cell not in targets and self.way_to(targets, unseen) == way:
                self.cell = next_to(self.cell, way)
                end = self.along(self.middle())
                # It plans through known cells; in an unknown one it reads the walls just before it has to brake.
                while self.cell not in self.seen:
                    yield self.straight(end, self.search_speed)
                    braking = self.wanted_speed ** 2 / 2 / self.rate
                    if end - self.along() < braking + 0.06 * self.side:
                        self.look()
            if self.cell in self.told["goals"]:
                end += 0.05 * self.side  # a run ends just past its middle
            while end - self.along() > 0.005 * self.side:
                yield self.straight(end + 0.002 * self.side, most)
            yield from self.rest(0.05)

    def runs(self):
        yield from self.rest(0.1)
        self.look()
        if not self.seen.intersection(self.told["goals"]):
            yield from self.go(self.told["goals"], True, self.search_speed)
            yield from self.home()
        while True:
            self.word = "fast"
            yield from self.go(self.told["goals"], False, self.fast_speed)
            yield from self.home()

    def home(self):
        self.word = "goal"
        start, heading = self.told["start"]
        yield from self.go([start], True, self.search_speed)
        yield from self.pivot(heading)
        yield from self.rest(0.1)

    # Duties of the motors.

    def answer(self, ticks):
        self.read(ticks)
        speed, rate, turning = next(self.work)
        twist = (turning - self.wanted_turning) / STEP
        self.wanted_turning = turning
        drive = self.duty("drive", speed, rate, self.speed)
        turn = self.duty("turn", turning, max(-80.0, min(80.0, twist)), self.turning)
        full = 32767 * self.told["motors.volts"] / self.volts
        duties = [round(max(-32767, min(32767, full * (drive + side * turn)))) for side in (-0.5, 0.5)]
        word, self.word = self.word, "drive"
        return word + BATCH * " {} {}".format(*duties)

    def duty(self, motor, wanted, rate, now):
        """Duty: feedforward by the nominal motor model, plus a proportional term for the error."""
        gain, time = self.told[f"motors.{motor}_gain"], self.told[f"motors.{motor}_time"] / 1000
        friction = self.told[f"motors.{motor}_dead_zone"] * max(-1.0, min(1.0, 200 * wanted / gain))
        return (wanted + time * (rate + 25 * (wanted - now))) / gain + friction


told, controller = {"goals": []}, None
for line in sys.stdin:
    word, *rest = line.split()
    if word == "sense":
        numbers = list(map(int, rest))
        print(controller.answer([numbers[i:i + 13] for i in range(0, len(numbers), 13)]), flush=True)
    elif word == "carried":
        controller.put_at_start()
    elif word == "size":
        told["size"] = int(rest[0]), int(rest[1])
    elif word == "start":
        told["start"] = (int(rest[0]), int(rest[1])), "nesw".index(rest[2][0])
    elif word == "goal":
        told["goals"].append((int(rest[0]), int(rest[1])))
    elif word == "begin":
        if not {"sensors.side_angle", "sensors.front_angle", "sensors.ranger_ahead", "sensors.gyro_step"} <= set(told):
            sys.exit("controller.py needs a robot with side and front sensors, a ToF sensor and a gyro, such as kerise")
        controller = Controller(told)
        print("labmouse pilot 1", flush=True)
    elif len(rest) == 1 and rest[0][0] in "-0123456789":
        told[word] = float(rest[0])
