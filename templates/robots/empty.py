"""Your own mouse: it drives ahead until a wall stops it."""


class Robot(object):
    def __init__(self, maze_dim):
        # The maze has maze_dim columns and maze_dim rows. The
        # mouse starts in the south-west corner, heading
        # north; the goal is the four cells in the centre.
        self.maze_dim = maze_dim

    def next_move(self, sensors):
        # The open cells to the left, ahead and to the right,
        # up to the next wall.
        left, ahead, right = sensors
        # A step: a turn of -90 (left), 0 or 90 (right)
        # degrees, then a movement of -3 to 3 cells. Once it
        # has been in the goal, return 'Reset', 'Reset' to go
        # back to the start for the speed run.
        return 0, 1
