// Your own mouse: ahead until a wall, then a turn.
const goals = [];
let width, height, stride, start;

// One step: `left`, `ahead` and `right` are the open cells up
// to the next wall. Answer 'move DEGREES CELLS' (-90, 0 or 90
// degrees clockwise, then up to 3 cells, negative backwards),
// 'reset' in a goal, or 'forfeit'.
function decide(left, ahead, right) {
  console.error(`I see ${left} to the left, ${ahead} ahead and ${right} to the right.`);
  return ahead > 0 ? 'move 0 1' : 'move 90 0';
}

// The conversation with the host, line by line. Notes for
// yourself go to console.error.
require('readline').createInterface({ input: process.stdin }).on('line', (line) => {
  const [word, ...rest] = line.split(' ');
  const [a, b, c] = rest.map(Number);
  if (word === 'size') [width, height] = [a, b];
  if (word === 'start') start = [a, b, rest[2]]; // column, row, 'north', 'east', 'south' or 'west'
  if (word === 'goal') goals.push([a, b]);
  if (word === 'stride') stride = a;
  if (word === 'begin') console.log('labmouse 1');
  if (word === 'sense') console.log(decide(a, b, c));
});
