// The page is held to three times its stated figures: what has slipped that far is a mistake, and no slow machine. Time is
// counted in processor time, and the best of a few tries counts, so that a busy machine does not matter.
import { expect, test } from 'vitest';
import { firstRun, frontDoor, memory, playing, twoMice, type Figure, type Opening } from '../../bench/measures';
import { size } from '../../bench/size';
import { proof } from './harness';
import stated from '../../bench/stated.json';

const most = (figure: Figure) => 3 * stated[figure].stated;

/** The first of three looks that will do, or the last of them. */
async function bestOf<Look>(look: () => Promise<Look>, willDo: (one: Look) => boolean): Promise<Look> {
  for (let i = 0; i < 2; ++i) {
    const one = await look();
    if (willDo(one)) return one;
  }
  return look();
}

test('the file is small', () => expect(size()).toBeLessThan(most('size')));

test.runIf(proof).each([
  ['movement, processor', frontDoor],
  ['run, processor', firstRun],
] as const)('%s', async (figure, look) => {
  // A tenth of what it may take: the paint can be held to the clock.
  const isQuick = ({ processor, paint }: Opening) => processor < most(figure) && paint < most('paint');
  await expect(bestOf(look, isQuick)).resolves.toSatisfy(isQuick);
});

// Frames a second depend on who else has the processors; what a frame costs does not. 60 of them have 16 ms each.
test.runIf(proof)('a replay of two mice in 64 by 64 cells', async () => {
  const page = await twoMice(64);
  const isCheap = ({ cost }: { cost: number }) => cost < most('cost');
  await expect(bestOf(() => playing(page, '64×', 1), isCheap)).resolves.toSatisfy(isCheap);
  expect(await memory(page)).toBeLessThan(most('memory'));
});
