// The form that holds a race in the page.
import type { About } from '../core/types';
import { h } from '../ui/dom';
import type { EarlyPage } from '../views/view';
import { counted } from './format';
import { holdRace, type Order } from './holding';

const usual = ['ariadne', 'flood-return', 'certify', 'flood', 'frontier'];
const usualRuns = 5;

interface Picks {
  element: HTMLElement;
  chosen(): string[];
}

function picks(title: string, names: { name: string; about: string; on: boolean }[]): Picks {
  const boxes = names.map(({ name, on }) => h('input', { type: 'checkbox', value: name, checked: on }));
  const setAll = (on: boolean) => boxes.forEach((box) => (box.checked = on));
  return {
    element: h(
      'fieldset',
      { class: 'picks' },
      h('legend', {}, title),
      h(
        'p',
        { class: 'row' },
        h('button', { type: 'button', onclick: () => setAll(true) }, 'All'),
        h('button', { type: 'button', onclick: () => setAll(false) }, 'None'),
      ),
      h('div', { class: 'list' }, ...boxes.map((box, i) => h('label', { title: names[i].about }, box, names[i].name))),
    ),
    chosen: () => boxes.filter((box) => box.checked).map((box) => box.value),
  };
}

const whole = (label: string, value: number, most: number) => {
  const input = h('input', { type: 'number', min: 1, max: most, step: 1, value, required: true });
  const read = () => Math.max(1, Math.min(most, Math.round(input.valueAsNumber) || value));
  return { element: h('label', { class: 'row' }, label, input), read };
};

/** The form, once it is known what the core brings. */
export function holdPanel(page: EarlyPage, about: About): HTMLElement {
  const mice = picks(
    'Mice',
    about.mice.map(({ name, summary }) => ({ name, about: summary, on: usual.includes(name) })),
  );
  const mazes = picks(
    'Mazes',
    about.mazes.map(({ name, width, height }) => ({ name, about: `${width}×${height}`, on: true })),
  );
  const runs = whole('runs of mice that throw dice', usualRuns, 100);
  const seed = whole('seed', 1, 2 ** 53 - 1);
  const bar = h('progress', { max: 1, value: 0, 'aria-label': 'Progress of the race' });
  const doing = h('span', { class: 'note' });
  const running = h(
    'div',
    { class: 'row', hidden: true },
    bar,
    doing,
    h('button', { type: 'button', onclick: () => stop() }, 'Stop'),
  );
  const start = h('button', { type: 'submit', class: 'main' }, 'Hold the race');
  let wanted = true;

  function stop() {
    wanted = false;
    doing.textContent = 'Stopping after this mouse …';
  }
  async function hold(order: Order) {
    wanted = true;
    start.disabled = true;
    running.hidden = false;
    try {
      const results = await holdRace(
        page.core,
        order,
        (now) => {
          bar.max = now.all;
          bar.value = now.done;
          doing.textContent = `${now.doing}, mouse ${now.done + 1} of ${now.all}`;
        },
        () => wanted,
      );
      if (!results) return page.tell('The race was stopped.');
      const entries = `${counted(results.mice.length, 'mouse', 'mice')}, ${counted(results.mazes.length, 'maze')}`;
      page.hold(results, `The race is over: ${entries}.`);
    } catch (error) {
      page.complain(error);
    } finally {
      start.disabled = false;
      running.hidden = true;
    }
  }
  function submit(event: Event) {
    event.preventDefault();
    const order: Order = { mice: mice.chosen(), mazes: mazes.chosen(), runs: runs.read(), seed: seed.read() };
    if (order.mice.length === 0 || order.mazes.length === 0)
      return page.complain('Choose at least one mouse and one maze.');
    void hold(order);
  }
  return h(
    'form',
    { class: 'hold', onsubmit: submit },
    h('div', { class: 'sides' }, mice.element, mazes.element),
    h('div', { class: 'row' }, runs.element, seed.element, start),
    running,
  );
}
