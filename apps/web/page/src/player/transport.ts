// The controls of time: buttons, the scrubber with the runs marked on it, the speed.
import type { DriveRun } from '../core/types';
import { h } from '../ui/dom';
import { rateOf, speeds } from './clock';
import { icon, type Icon } from './icons';
import { timeOf, type Actions, type Mark, type Panel, type Side, type State } from './state';
import { short } from './figures';
import { momentText } from './words';

function button(name: Icon, label: string, keys: string, onclick: () => void): HTMLButtonElement {
  return h('button', { type: 'button', 'aria-label': label, title: `${label} (${keys})`, onclick }, icon(name));
}

/** Of a run in seconds. */
const runTones: Record<DriveRun['kind'], string> = { search: 'to-goal', home: 'onwards', fast: 'route' };

/** One strip a play: how long it explored until the goal and from there on, and how long it ran. */
function strip(side: Side, end: number): HTMLElement {
  const { track } = side;
  const stop = timeOf(side, 'end')!;
  const reset = timeOf(side, 'speed') ?? stop;
  const goal = Math.min(timeOf(side, 'goal') ?? reset, reset);
  const part = (className: string, from: number, to: number) => {
    const element = h('span', { class: className });
    element.style.left = `${end > 0 ? (100 * from) / end : 0}%`;
    element.style.width = `${end > 0 ? (100 * (to - from)) / end : 0}%`;
    return element;
  };
  if (track.drive) {
    const runs = track.drive.runs.map(({ kind, begin, end: stops }) => part(runTones[kind], begin / 1e6, stops / 1e6));
    return h('div', { class: 'strip' }, ...runs);
  }
  if (track.play.world === 'mms') return h('div', { class: 'strip' }, part('to-goal', 0, stop));
  return h(
    'div',
    { class: 'strip' },
    part('to-goal', 0, goal),
    part('onwards', goal, reset),
    part('route', reset, stop),
  );
}

function speedChoice(state: State, actions: Actions) {
  const names = [...speeds.map((speed, i): [string, number] => [`${speed}×`, i]), ['fit', -1] as [string, number]];
  const select = h(
    'select',
    { 'aria-label': 'Speed', title: 'Speed (+ and −)', onchange: () => actions.setSpeed(Number(select.value)) },
    ...names.map(([name, value]) => h('option', { value }, name)),
  );
  const rate = h('span', { class: 'rate' });
  const update = () => {
    select.value = String(state.clock.speed);
    const unit = state.sides.some(({ track }) => track.play.world === 'steps') ? 'steps/s' : 's/s';
    rate.textContent = `${short(Math.round(rateOf(state.clock) * 100) / 100)} ${unit}`;
  };
  return { element: h('label', { class: 'speed' }, h('span', {}, 'Speed '), select, rate), update };
}

export function createTransport(state: State, actions: Actions): Panel {
  const play = button('play', 'Play', 'space', actions.toggle);
  const pauseIcon = icon('pause');
  const playIcon = play.firstElementChild!;
  const loop = button('loop', 'Repeat from the start', 'L', () => actions.setLoop(!state.clock.loop));
  const range = h('input', {
    type: 'range',
    min: 0,
    step: 'any',
    'aria-label': 'Moment of the replay',
    oninput: () => actions.seek(Number(range.value)),
  });
  const strips = h('div', { class: 'strips', 'aria-hidden': 'true' });
  const speed = speedChoice(state, actions);
  const mark = (label: string, name: Mark) =>
    h('button', { type: 'button', class: 'mark', onclick: () => actions.jump(name) }, label);
  const marks = { start: mark('Exploration', 'start'), goal: mark('Goal', 'goal'), speed: mark('Speed run', 'speed') };
  const buttons = h(
    'div',
    { class: 'buttons', role: 'group', 'aria-label': 'Replay' },
    h(
      'span',
      { class: 'moves' },
      button('start', 'To the start', 'home', () => actions.jump('start')),
      button('back', 'One step back', 'left arrow', () => actions.step(-1)),
      play,
      button('forward', 'One step forward', 'right arrow', () => actions.step(1)),
      button('end', 'To the end', 'end', () => actions.jump('end')),
    ),
    h('span', { class: 'marks' }, marks.start, marks.goal, marks.speed),
    h('span', { class: 'pace' }, speed.element, loop),
  );
  const fold = button('panel', 'The panel', 'P', actions.fold);
  fold.classList.add('fold');
  const screen = button('screen', 'Full screen', 'F', actions.enlarge);
  screen.classList.add('screen');
  screen.hidden = !document.fullscreenEnabled;
  const looks = h(
    'div',
    { class: 'looks', role: 'group', 'aria-label': 'Picture' },
    button('nearer', 'Nearer', 'Z, wheel, two fingers', () => actions.zoom(1)),
    button('farther', 'Farther', 'X', () => actions.zoom(-1)),
    screen,
    fold,
  );
  let sides: Side[] = [];
  let playing: boolean | null = null;

  function updateSides() {
    sides = state.sides;
    range.max = String(state.clock.end);
    strips.replaceChildren(...sides.map((side) => strip(side, state.clock.end)));
    const { track } = sides[state.chosen];
    const mms = track.play.world === 'mms';
    marks.start.hidden = mms;
    marks.start.textContent = track.drive ? 'Search' : 'Exploration';
    marks.speed.textContent = track.drive ? 'Fast run' : 'Speed run';
    marks.speed.hidden = mms;
    marks.goal.disabled = track.goalFrame < 0;
    marks.speed.disabled = track.resetFrame < 0;
  }
  return {
    element: h('div', { class: 'transport' }, h('div', { class: 'scrubber' }, range, strips), buttons, looks),
    update() {
      if (sides !== state.sides) updateSides();
      range.value = String(state.clock.time);
      if (playing !== state.clock.playing) {
        playing = state.clock.playing;
        play.setAttribute('aria-label', playing ? 'Pause' : 'Play');
        play.title = playing ? 'Pause (space)' : 'Play (space)';
        play.replaceChildren(playing ? pauseIcon : playIcon);
      }
      if (!playing) range.setAttribute('aria-valuetext', state.sides.map(momentText).join(' '));
      loop.setAttribute('aria-pressed', String(state.clock.loop));
      fold.setAttribute('aria-pressed', String(!state.folded));
      speed.update();
    },
  };
}
