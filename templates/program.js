// A mouse for labmouse: it floods to a goal cell by cell, resets, and takes the shortest way that it saw.
const WAYS = [100, 1, -100, -1]; // to the north, east, south, west; cell (x, y) is x + 100 y
const goals = [], cells = new Set(), isOpen = new Map(); // isOpen: walls seen, each as the sum of its cells
let stride, start, cell, heading, steps = 0, racing = false;

function flood(longest, unseen) { // each cell's first move to a goal; `unseen`: whether unseen walls are open
  const moves = new Map(goals.map(goal => [goal, [0, 0]]));
  for (const cell of moves.keys()) // those that are added meanwhile, too
    for (let to = 0; to < 4; to++)
      for (let n = 1, end = cell; n <= longest && (isOpen.get(2 * end + WAYS[to]) ?? unseen); n++)
        if (cells.has(end += WAYS[to]) && !moves.has(end)) moves.set(end, [(to + 2) % 4, n]);
  return moves;
}
require('readline').createInterface({input: process.stdin}).on('line', line => {
  const [word, ...rest] = line.split(' '), [x, y] = rest.map(Number);
  if (word === 'size') for (let i = 0; i < x * y; i++) cells.add(i % x + 100 * Math.floor(i / x));
  if (word === 'start') start = [x + 100 * y, 'nesw'.indexOf(rest[2][0])];
  if (word === 'goal') goals.push(x + 100 * y);
  if (word === 'stride') stride = x;
  if (word !== 'sense') return word === 'begin' && console.log('labmouse 1');
  if (steps++ === 0) [cell, heading] = start;
  for (const [i, way] of [3, 0, 1].map(turn => WAYS[(heading + turn) % 4]).entries()) // left, ahead, right
    for (let n = 0; n <= rest[i]; n++) isOpen.set(2 * cell + (2 * n + 1) * way, n < rest[i]);
  if (steps > 1 && goals.includes(cell)) { racing = true; steps = 0; return console.log('reset'); }
  let [to, n] = flood(racing ? stride : 1, !racing).get(cell), turn = (to - heading + 5) % 4 - 1;
  if (turn === 2) [turn, n] = isOpen.has(2 * cell - WAYS[heading]) ? [0, -n] : [1, 0]; // it backs, or looks
  cell += n * WAYS[heading = (heading + turn + 4) % 4];
  console.log(`move ${90 * turn} ${n}`); // turns: -1 left, 0 ahead, 1 right, 2 behind
});
