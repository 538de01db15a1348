// Keeps its left hand on the wall until it enters a goal.
// Lost where the goal stands free: what would you do about
// that?

// To the north, east, south and west.
const WAYS = [[0, 1], [1, 0], [0, -1], [-1, 0]];
const goals = new Set();
// Of each cell the way by which the mouse last left it.
const lastWay = new Map();
let start, cell, heading, racing = false;

const nameOf = ([x, y]) => `${x},${y}`;

// Turns by -90, 0 or 90 degrees, then goes so many cells;
// `way` is where it looks then.
function move(degrees, cells) {
  heading = (heading + degrees / 90 + 4) % 4;
  if (cells > 0) lastWay.set(nameOf(cell), heading);
  cell = [cell[0] + cells * WAYS[heading][0], cell[1] + cells * WAYS[heading][1]];
  return `move ${degrees} ${cells}`;
}

// One step: `left`, `ahead` and `right` are the open cells up
// to the next wall.
function decide(left, ahead, right) {
  if (!racing && goals.has(nameOf(cell))) {
    racing = true;
    [cell, heading] = start;
    return 'reset';
  }
  if (racing) {
    const turn = (lastWay.get(nameOf(cell)) - heading + 4) % 4; // 1 is right, 3 is left, 2 is behind
    return turn === 2 ? move(90, 0) : move(turn === 3 ? -90 : 90 * turn, 1);
  }
  if (left > 0) return move(-90, 1);
  if (ahead > 0) return move(0, 1);
  if (right > 0) return move(90, 1);
  return move(90, 0); // a dead end: it turns round, in two steps
}

// The conversation with the host, line by line. Notes for
// yourself go to console.error.
require('readline').createInterface({ input: process.stdin }).on('line', (line) => {
  const [word, ...rest] = line.split(' ');
  const [a, b, c] = rest.map(Number);
  if (word === 'start') {
    start = [[a, b], ['north', 'east', 'south', 'west'].indexOf(rest[2])];
    [cell, heading] = start;
  }
  if (word === 'goal') goals.add(nameOf([a, b]));
  if (word === 'begin') console.log('labmouse 1');
  if (word === 'sense') console.log(decide(a, b, c));
});
