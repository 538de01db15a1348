// The list of all steps: a table of which only the lines in view exist.
import { h } from '../ui/dom';
import type { Actions, Panel, State } from './state';
import type { Track } from './track';
import { headings, placeText } from './figures';

const lineHeight = 24;
const spare = 4;

interface Column {
  name: string;
  text: (track: Track, frame: number) => string;
}

const runs = ['exploration', 'speed run'];
const kinds = ['search', 'way home', 'fast run'];
const place: Column = { name: 'at', text: ({ x, y }, i) => placeText(x[i], y[i]) };
const heading: Column = { name: 'heading', text: (track, i) => headings[track.heading[i] & 7] };
const action: Column = { name: 'does', text: ({ play, last }, i) => (i < last ? play.action[i] : play.outcome) };
const blocked: Column = {
  name: 'blocked',
  text: ({ play, last }, i) => (i < last && play.blocked[i] ? 'by a wall' : ''),
};
const run: Column = { name: 'run', text: (track, i) => (i === track.last ? 'end' : runs[track.run[i]]) };
const seconds: Column = { name: 'seconds', text: (track, i) => track.time[i].toFixed(2) };
const reading: Column = {
  name: 'left, ahead, right',
  text: ({ play: { left, ahead, right } }, i) => (i < left.length ? `${left[i]} ${ahead[i]} ${right[i]}` : ''),
};

const kind: Column = { name: 'run', text: ({ run, last }, i) => (i === last ? 'end' : kinds[run[i]]) };
const clock: Column = { name: 'seconds', text: ({ time }, i) => time[i].toFixed(3) };
const lasts: Column = {
  name: 'takes, ms',
  text: ({ time, last }, i) => (i < last ? (1000 * (time[i + 1] - time[i])).toFixed(1) : ''),
};

const columns = {
  steps: [run, place, heading, reading, action, blocked],
  mms: [seconds, place, heading, action, blocked],
  seconds: [kind, clock, place, heading, action, lasts],
};

interface Line {
  element: HTMLElement;
  button: HTMLButtonElement;
  cells: HTMLElement[];
  frame: number;
}

export function createSteps(state: State, actions: Actions): Panel {
  const top = h('tr', { 'aria-hidden': 'true', class: 'spacer' });
  const bottom = h('tr', { 'aria-hidden': 'true', class: 'spacer' });
  const head = h('tr');
  const body = h('tbody');
  const table = h('table', { 'aria-label': 'Steps' }, h('thead', {}, head), body);
  const scroller = h(
    'div',
    { class: 'scroller', tabindex: 0, role: 'region', 'aria-label': 'Steps', onscroll: () => render() },
    table,
  );
  const chooser = h('div', { class: 'chooser', role: 'group', 'aria-label': 'Whose steps' });
  const element = h('section', { class: 'steps' }, h('h3', {}, 'Steps'), chooser, scroller);
  let lines: Line[] = [];
  let track: Track | null = null;
  let sides: unknown = null;
  let first = -1;
  let current = -1;

  function makeLine(): Line {
    const button = h('button', { type: 'button', tabindex: -1 });
    const cells = columns[track!.play.world].map(() => h('td'));
    const element = h('tr', {}, h('th', { scope: 'row' }, button), ...cells);
    const line: Line = { element, button, cells, frame: -1 };
    element.addEventListener('click', () => line.frame >= 0 && actions.seek(track!.time[line.frame]));
    return line;
  }
  function fill(line: Line, frame: number) {
    line.frame = frame;
    line.element.hidden = frame > track!.last;
    if (frame > track!.last) return;
    line.element.setAttribute('aria-rowindex', String(frame + 2));
    line.button.textContent = frame === track!.last ? '' : String(frame + 1);
    line.button.setAttribute('aria-label', frame === track!.last ? 'the end' : `step ${frame + 1}`);
    columns[track!.play.world].forEach((column, i) => {
      line.cells[i].textContent = column.text(track!, frame);
    });
  }
  function mark(line: Line) {
    if (line.frame === current) line.element.setAttribute('aria-current', 'step');
    else line.element.removeAttribute('aria-current');
  }
  function render(all = false) {
    if (!track) return;
    const begin = Math.max(0, Math.floor(scroller.scrollTop / lineHeight) - spare);
    if (all || begin !== first) {
      first = begin;
      top.style.height = `${begin * lineHeight}px`;
      bottom.style.height = `${Math.max(0, track.last + 1 - begin - lines.length) * lineHeight}px`;
      lines.forEach((line, i) => fill(line, begin + i));
    }
    lines.forEach(mark);
  }
  function follow() {
    const from = scroller.scrollTop;
    const room = scroller.clientHeight - 2 * lineHeight;
    const at = current * lineHeight;
    if (at < from || at > from + room)
      scroller.scrollTop = Math.max(0, current - Math.floor(room / lineHeight / 3)) * lineHeight;
  }
  function rebuild() {
    track = state.sides[state.chosen].track;
    head.replaceChildren(
      ...['step', ...columns[track.play.world].map(({ name }) => name)].map((name) => h('th', { scope: 'col' }, name)),
    );
    const count = Math.ceil((scroller.clientHeight || 320) / lineHeight) + 2 * spare;
    lines = Array.from({ length: count }, makeLine);
    body.replaceChildren(top, ...lines.map((line) => line.element), bottom);
    table.setAttribute('aria-rowcount', String(track.last + 2));
    scroller.scrollTop = 0;
    render(true);
  }
  function choose() {
    chooser.hidden = state.sides.length < 2;
    chooser.replaceChildren(
      ...state.sides.map(({ name }, i) =>
        h(
          'button',
          { type: 'button', title: name, 'aria-pressed': String(i === state.chosen), onclick: () => actions.choose(i) },
          name,
        ),
      ),
    );
  }
  return {
    element,
    update() {
      const side = state.sides[state.chosen];
      if (sides !== state.sides || track !== side.track) {
        sides = state.sides;
        choose();
        rebuild();
        current = -1;
      }
      if (current === side.scene.past.frame) return;
      current = side.scene.past.frame;
      follow();
      render();
    },
  };
}
