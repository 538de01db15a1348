// What the signs of the drawing mean.
import { sample, type SampleName } from '../player/samples';
import { h } from '../ui/dom';

export type Key = ReturnType<typeof createKey>;

const entry = (name: SampleName, words: string) => h('li', sample(name), h('span', words));

export function createKey() {
  const route = entry('search', 'a shortest run');
  route.classList.add('route');
  const element = h(
    'ul.draw-key',
    { 'aria-label': 'Legend' },
    entry('walls', 'wall'),
    entry('start', 'start; the arrow is the start heading'),
    entry('goal', 'goal'),
    route,
  );
  return { element /** Whether the shortest run is drawn. */, setRoute: (drawn: boolean) => (route.hidden = !drawn) };
}
