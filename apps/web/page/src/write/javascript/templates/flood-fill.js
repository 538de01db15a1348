// Flood fill: takes unseen walls for open, goes to where the
// goal is nearest, then races on what it has seen.

// Cells; longer steps search faster and see less.
const LONGEST_STEP_OF_SEARCH = 1;
// To the north, east, south and west.
const WAYS = [[0, 1], [1, 0], [0, -1], [-1, 0]];
const goals = [];
// True is open, false is closed; what is missing has not been
// seen.
const walls = new Map();
let width, height, stride, start, x, y, heading, racing = false;

// The wall of a cell on that side, under one name from both
// of its sides.
function wallOf(x, y, way) {
  return way < 2 ? `${x},${y},${way}` : `${x + WAYS[way][0]},${y + WAYS[way][1]},${way - 2}`;
}
const isInside = (x, y) => x >= 0 && y >= 0 && x < width && y < height;

// Whether the mouse takes the wall for open. In a race it
// trusts only what it has seen.
function isOpen(x, y, way) {
  if (!isInside(x + WAYS[way][0], y + WAYS[way][1])) return false;
  return walls.get(wallOf(x, y, way)) ?? !racing;
}

// Steps from each cell to the nearest of the targets, for
// steps of up to so many cells.
function flood(targets, longest) {
  const steps = new Map(targets.map(([x, y]) => [`${x},${y}`, 0]));
  const queue = [...targets];
  for (const [x, y] of queue) // grows while it is read
    for (let way = 0; way < 4; way++)
      for (let n = 1, cx = x, cy = y; n <= longest && isOpen(cx, cy, way); n++) {
        cx += WAYS[way][0];
        cy += WAYS[way][1];
        if (steps.has(`${cx},${cy}`)) continue;
        steps.set(`${cx},${cy}`, steps.get(`${x},${y}`) + 1);
        queue.push([cx, cy]);
      }
  return steps;
}

// The step that leads nearest to the targets: ahead rather
// than to a side, and a turn where they lie behind.
function towards(targets, longest) {
  const steps = flood(targets, longest);
  let best = { steps: Infinity, degrees: 90, cells: 0 };
  for (const turn of [0, -1, 1, 2]) {
    const way = (heading + turn + 4) % 4;
    for (let n = 1, cx = x, cy = y; n <= longest && isOpen(cx, cy, way); n++) {
      cx += WAYS[way][0];
      cy += WAYS[way][1];
      const left = steps.get(`${cx},${cy}`) ?? Infinity;
      if (left >= best.steps) continue;
      best = { steps: left, degrees: turn === 2 ? 90 : 90 * turn, cells: turn === 2 ? 0 : n };
    }
  }
  return best;
}

// One step: `left`, `ahead` and `right` are the open cells up
// to the next wall.
function decide(left, ahead, right) {
  look(-1, left);
  look(0, ahead);
  look(1, right);
  if (!racing && goals.some(([gx, gy]) => gx === x && gy === y)) {
    racing = true;
    [x, y, heading] = start;
    return 'reset';
  }
  const { degrees, cells } = towards(goals, racing ? stride : LONGEST_STEP_OF_SEARCH);
  heading = (heading + degrees / 90 + 4) % 4;
  x += cells * WAYS[heading][0];
  y += cells * WAYS[heading][1];
  return `move ${degrees} ${cells}`;
}

// Keeps what a reading says: so many open walls, then a
// closed one.
function look(turn, open) {
  const way = (heading + turn + 4) % 4;
  for (let n = 0; n <= open; n++) walls.set(wallOf(x + n * WAYS[way][0], y + n * WAYS[way][1], way), n < open);
}

// The conversation with the host, line by line. Notes for
// yourself go to console.error.
require('readline').createInterface({ input: process.stdin }).on('line', (line) => {
  const [word, ...rest] = line.split(' ');
  const [a, b, c] = rest.map(Number);
  if (word === 'size') [width, height] = [a, b];
  if (word === 'start') [x, y, heading] = start = [a, b, ['north', 'east', 'south', 'west'].indexOf(rest[2])];
  if (word === 'goal') goals.push([a, b]);
  if (word === 'stride') stride = a;
  if (word === 'begin') console.log('labmouse 1');
  if (word === 'sense') console.log(decide(a, b, c));
});
