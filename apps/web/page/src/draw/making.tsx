// A new drawing: empty, closed, or from a generator.
import { useState } from 'preact/hooks';
import type { MazeData } from '../core/types';
import { firstGeneration, Generator, orderOf } from '../ui/generator';
import type { Page } from '../page/page';
import { withAllClosed } from './model';
import { errorText } from '../ui/format';

const closed = 'closed';
const more = [{ name: closed, summary: 'every inner wall closed' }];

/** `made` hears of each new maze. */
export function Making({ page: { core, about }, made }: { page: Page; made(maze: MazeData): void }) {
  const [generation, change] = useState(firstGeneration('empty'));
  const [error, setError] = useState('');
  async function make(event: Event) {
    event.preventDefault();
    setError('');
    const order = orderOf(generation, more);
    try {
      const of = order.generator === closed ? { ...order, generator: 'empty' } : order;
      const { maze } = await core.call('make_maze', of);
      made(order.generator === closed ? withAllClosed({ ...maze, name: `closed-${maze.width}x${maze.height}` }) : maze);
    } catch (error) {
      setError(errorText(error));
    }
  }
  return (
    <form class="making" onSubmit={make} novalidate>
      <Generator {...{ about, generation, change, error, more }} />
      <button type="submit">New drawing</button>
    </form>
  );
}
