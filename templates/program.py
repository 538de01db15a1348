"""A mouse for labmouse: flood fill cell by cell to a goal, then a speed run on the shortest seen route."""
WAYS = 100, 1, -100, -1  # to the north, east, south, west; cell (x, y) is the number x + 100 y
host, goals, is_open = map(str.split, open(0)), [], {}  # is_open: seen walls, by the sum of both cells

def flood(longest, unseen):  # first move of each cell to a goal; `unseen`: whether unseen walls count as open
    moves, queue = {goal: (0, 0) for goal in goals}, list(goals)
    for cell, to, n in ((cell, to, n) for cell in queue for to in range(4) for n in range(1, longest + 1)):
        end, walls = cell + n * WAYS[to], (2 * cell + odd * WAYS[to] for odd in range(1, 2 * n, 2))
        if end in cells and end not in moves and all(is_open.get(wall, unseen) for wall in walls):
            moves[end] = (to + 2) % 4, n
            queue.append(end)
    return moves

for word, *rest in host:  # briefing
    if word == "size": cells = {x + 100 * y for x in range(int(rest[0])) for y in range(int(rest[1]))}
    if word == "start": start = int(rest[0]) + 100 * int(rest[1]), "nesw".index(rest[2][0])
    if word == "goal": goals.append(int(rest[0]) + 100 * int(rest[1]))
    if word == "stride": stride = int(rest[0])
    if word == "begin": print("labmouse 1", flush=True); break
for longest, unseen, (cell, heading) in (1, True, start), (stride, False, start):  # search run, speed run
    for steps, (_, *readings) in enumerate(host):
        for way, free in zip([WAYS[(heading + turn) % 4] for turn in (-1, 0, 1)], map(int, readings)):
            is_open.update((2 * cell + (2 * n + 1) * way, n < free) for n in range(free + 1))
        if steps > 0 and cell in goals: print("reset", flush=True); break
        to, n = flood(longest, unseen)[cell]
        turn = (to - heading + 1) % 4 - 1  # -1 left, 0 ahead, 1 right, 2 behind: reverse, or turn and look
        if turn == 2: turn, n = (0, -n) if 2 * cell - WAYS[heading] in is_open else (1, 0)
        cell += n * WAYS[heading := (heading + turn) % 4]
        print("move", 90 * turn, n, flush=True)
