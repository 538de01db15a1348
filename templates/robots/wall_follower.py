"""Keeps its left hand on the wall until it enters the goal. It fails if the goal's walls do not reach the border.

Column x and row y are the number x + 100 * y."""

STEPS = [100, 1, -100, -1]  # to the next cell in the north, east, south, west: the directions 0 to 3


class Robot(object):
    def __init__(self, maze_dim):
        middle = ((maze_dim - 1) // 2, maze_dim // 2)  # equal for an odd size
        self.goals = [x + 100 * y for x in middle for y in middle]
        self.exits = {}  # for each cell, the direction in which it last left it
        self.cell, self.heading, self.racing = 0, 0, False

    def next_move(self, sensors):
        if self.cell in self.goals:
            self.cell, self.heading, self.racing = 0, 0, True
            return 'Reset', 'Reset'
        if self.racing:
            return self.race()
        left, ahead, right = sensors
        if left > 0:
            return self.move(-1, 1)
        if ahead > 0:
            return self.move(0, 1)
        if right > 0:
            return self.move(1, 1)
        return self.move(1, 0)  # a dead end: turns now, and again in the next step

    def race(self):
        """The longest straight step along the recorded way."""
        direction, cells = self.exits[self.cell], 1
        while cells < 3 and self.exits.get(self.cell + cells * STEPS[direction]) == direction:
            cells += 1
        return self.move((direction - self.heading + 1) % 4 - 1, cells)

    def move(self, turn, cells):
        """Updates the position, and returns the step. turn: -1 to the left, 0 for none, 1 to the right."""
        self.heading = (self.heading + turn) % 4
        for _ in range(cells):
            self.exits[self.cell] = self.heading
            self.cell += STEPS[self.heading]
        return 90 * turn, cells
