// A new drawing: empty, closed, or from a generator.
import type { MazeData } from '../core/types';
import { h } from '../ui/dom';
import { createGenerator } from '../ui/generator';
import type { Page } from '../page/page';
import { withAllClosed } from './model';
import { errorText } from '../ui/format';

const closed = 'closed';

/** `made` hears of each new maze. */
export function createMaking(page: Page, made: (maze: MazeData) => void): HTMLElement {
  const more = [{ name: closed, summary: 'every inner wall closed' }];
  const generator = createGenerator(page.about, { first: 'empty', more });
  async function make(event: Event) {
    event.preventDefault();
    generator.complain('');
    const order = generator.order();
    try {
      const of = order.generator === closed ? { ...order, generator: 'empty' } : order;
      const { maze } = await page.core.call('make_maze', of);
      made(order.generator === closed ? withAllClosed({ ...maze, name: `closed-${maze.width}x${maze.height}` }) : maze);
    } catch (error) {
      generator.complain(errorText(error));
    }
  }
  return h(
    'form.making',
    { onsubmit: make, novalidate: true },
    generator.element,
    h('button', { type: 'submit' }, 'New drawing'),
  );
}
