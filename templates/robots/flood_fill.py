"""Flood fill: counts unseen walls as open, moves to lower distances to the goal, then races over seen cells.

The goal is unknown: it tries the centre first. Column x and row y are the number x + 100 * y."""

LONGEST_STEP_OF_SEARCH = 3  # cells: shorter ones search more slowly and see more
STEPS = [100, 1, -100, -1]  # to the next cell in the north, east, south, west: the directions 0 to 3
STRAIGHT, LEFT, RIGHT, BACK = 0, -1, 1, 2


class Robot(object):
    def __init__(self, maze_dim):
        middle = ((maze_dim - 1) // 2, maze_dim // 2)  # equal for an odd size
        self.goals = [x + 100 * y for x in middle for y in middle]
        self.others = [x + 100 * y for x in range(maze_dim) for y in range(maze_dim)]
        self.at_start, self.asked = None, False  # readings at the start; whether it has just tried a reset
        self.is_open = {}  # known walls, by the sum of both cells; first, the border
        for n in range(maze_dim):
            for cell, direction in ((n + 100 * (maze_dim - 1), 0), (maze_dim - 1 + 100 * n, 1), (n, 2), (100 * n, 3)):
                self.is_open[2 * cell + STEPS[direction]] = False
        self.cell, self.heading, self.racing = 0, 0, False

    def next_move(self, sensors):
        if self.at_start is None:
            self.at_start = sensors
        if self.asked:
            self.hear(sensors == self.at_start)
        self.look(sensors)
        if self.cell in self.goals:
            self.asked = True
            return 'Reset', 'Reset'
        return self.move_towards(self.goals)

    def hear(self, was_goal):
        """Result of the reset: either it is back at the start, or it did not move, and this cell is no goal."""
        self.asked = False
        if was_goal:
            if self.goals is self.others:
                self.goals = [self.cell]
            self.cell, self.heading, self.racing = 0, 0, True
        else:
            self.others.remove(self.cell)
            self.goals = self.others

    def look(self, sensors):
        """Records the walls that it sees: open ones, then a closed one."""
        for turn, free in zip((LEFT, STRAIGHT, RIGHT), sensors):
            step = STEPS[(self.heading + turn) % 4]
            for distance in range(free + 1):
                self.is_open[2 * self.cell + (2 * distance + 1) * step] = distance < free

    def move_towards(self, targets):
        """The longest step to a cell nearer to the targets; prefers straight on, then left, right, back."""
        away = self.flood(targets)
        for turn in (STRAIGHT, LEFT, RIGHT, BACK):
            direction = (self.heading + turn) % 4
            ends = self.ends(self.cell, direction)
            nearer = [cells for cells, end in enumerate(ends, 1) if away.get(end, away[self.cell]) < away[self.cell]]
            if nearer:
                return self.move(turn, direction, nearer[-1])
        return 0, 0  # there is no way

    def flood(self, targets):
        """Distance of each cell to the targets, in steps; stops at the present cell."""
        away = {cell: 0 for cell in targets}
        queue = list(targets)
        for cell in queue:  # includes cells added during the loop
            if cell == self.cell:
                break
            for direction in range(4):
                for end in self.ends(cell, direction):
                    if end not in away:
                        away[end] = away[cell] + 1
                        queue.append(end)
        away.setdefault(self.cell, 0)
        return away

    def ends(self, cell, direction):
        """Cells that one step can reach in a direction, nearest first."""
        ends, step = [], STEPS[direction]
        most = 3 if self.racing else LONGEST_STEP_OF_SEARCH
        while len(ends) < most and self.is_open.get(2 * cell + step, not self.racing):
            cell += step
            ends.append(cell)
        return ends

    def move(self, turn, direction, most):
        """Shortens the step to walls known to be open, updates the position, and returns the step."""
        step, cells = STEPS[direction], 1
        while cells < most and self.is_open.get(2 * self.cell + (2 * cells + 1) * step):
            cells += 1
        self.cell += cells * step
        if turn == BACK:
            return 0, -cells  # in reverse, without a turn
        self.heading = direction
        return 90 * turn, cells
