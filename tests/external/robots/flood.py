"""The mouse `flood` (labmouse/strategies/flood.cpp) as a capstone robot. Python 2.7 and 3.

A cell is a complex number, and so is a direction: north is 1j, times 1j turns left. A wall is the sum of its cells."""


class Robot(object):
    def __init__(self, maze_dim):
        self.cells = set(complex(x, y) for x in range(maze_dim) for y in range(maze_dim))
        centre = (maze_dim // 2 - 1, maze_dim // 2)
        self.goals = [complex(x, y) for x in centre for y in centre]
        self.is_open = {}  # the walls that were seen
        self.cell, self.heading, self.racing = 0j, 1j, False

    def next_move(self, sensors):
        self.look(sensors)
        if self.cell in self.goals:
            self.cell, self.heading, self.racing = 0j, 1j, True
            return ("Reset", "Reset")
        rotation, way, cells = self.plan()
        known = 1  # at least: only behind the start is a wall that it did not see, and that is the border
        while known < cells and 2 * self.cell + (2 * known + 1) * way in self.is_open:
            known += 1
        self.cell += known * way
        if way == -self.heading:
            return (0, -known)
        self.heading = way
        return (rotation, known)

    def look(self, sensors):
        for way, free in zip((self.heading * 1j, self.heading, self.heading * -1j), sensors):
            self.is_open.update((2 * self.cell + (2 * n + 1) * way, n < free) for n in range(free + 1))

    def plan(self):
        """The first move of a shortest way: ahead, left, right or back, and the longest."""
        away = self.flood()
        for rotation, turn in ((0, 1), (-90, 1j), (90, -1j), (0, -1)):
            way = self.heading * turn
            moves = [n for n, end in self.moves(self.cell, way) if away[end] + 1 == away[self.cell]]
            if moves:
                return rotation, way, moves[-1]

    def flood(self):
        """How many moves each cell is away from the goal."""
        away, queue = dict.fromkeys(self.goals, 0), list(self.goals)
        for cell in queue:
            for way in (1j, 1, -1j, -1):
                for _, end in self.moves(cell, way):
                    if end not in away:
                        away[end] = away[cell] + 1
                        queue.append(end)
        return away

    def moves(self, cell, way):
        """Moves through walls that are not known to be closed; in the speed run, that are known to be open."""
        for n in (1, 2, 3):
            if not self.is_open.get(2 * cell + way, not self.racing) or cell + way not in self.cells:
                return
            cell += way
            yield n, cell
