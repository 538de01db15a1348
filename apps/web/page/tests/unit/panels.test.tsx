// @vitest-environment happy-dom
// The panels of the player, each as the tree that it is.
import { render, type VNode } from 'preact';
import { describe, expect, it } from 'vitest';
import type { Candidate, Play, Reasons as Choice } from '../../src/core/types';
import { Facts } from '../../src/player/facts';
import { Files } from '../../src/player/files';
import { usualLayers } from '../../src/player/layers';
import { LastWords } from '../../src/player/last-words';
import { Legend } from '../../src/player/legend';
import { PartingPoint } from '../../src/player/parting-panel';
import { Reasons } from '../../src/player/reasons';
import { Runs } from '../../src/player/runs';
import { Caption } from '../../src/player/side';
import { Steps } from '../../src/player/steps';
import { prepare } from '../../src/player/track';
import { Transport } from '../../src/player/transport';
import { momentText } from '../../src/player/words';
import type { Page } from '../../src/page/page';
import { mms, seconds, steps } from './plays';
import { actionsOf, sideOf, stateOf } from './sides';

/** Draws it in a room, again and again. */
function drawing() {
  const room = document.createElement('div');
  document.body.append(room);
  return { room, draw: (tree: VNode) => render(tree, room) };
}
function drawn(tree: VNode): HTMLElement {
  const { room, draw } = drawing();
  draw(tree);
  return room;
}
const all = (room: HTMLElement, selector: string) => [...room.querySelectorAll<HTMLElement>(selector)];
const texts = (room: HTMLElement, selector: string) => all(room, selector).map(({ textContent }) => textContent);
const nothing = actionsOf([]);
/** What happens after a click is drawn a little later. */
const settled = () => new Promise((done) => setTimeout(done));

function factsOf(...sides: ReturnType<typeof sideOf>[]): Map<string, string[]> {
  const room = drawn(<Facts state={stateOf(sides)} actions={nothing} />);
  return new Map(all(room, 'tbody tr').map((row) => [texts(row, 'th')[0]!, texts(row, 'td') as string[]]));
}

describe('numbers', () => {
  it('are those of the moment and of the whole', () => {
    const facts = factsOf(sideOf(steps(), 4));
    expect(facts.get('steps')).toEqual(['4 of 8']);
    expect(facts.get('mouse at')).toEqual(['(2,1) south']);
    expect(facts.get('speed + search')).toEqual(['0 + 4 / 30']);
    expect(facts.get('score so far')).toEqual(['0.133']);
    expect(facts.get('first lost step')).toEqual(['4']);
  });
  it('are subtracted where two contests are of one world and one maze', () => {
    const two = factsOf(sideOf(steps(), 8), sideOf(steps({ mouse: 'other', score: 3 })));
    expect(two.get('score')).toEqual(['3.167', '3.000', '+0.167']);
    expect(two.get('steps')).toEqual(['8 of 8', '0 of 8', '+8']);
    const others = { ...steps().maze, name: 'other', walls: steps().maze.walls.map((sides) => sides ^ 1) };
    expect(factsOf(sideOf(steps()), sideOf(steps({ maze: others }))).get('score')).toHaveLength(2);
    expect(factsOf(sideOf(steps()), sideOf(mms())).get('score')).toHaveLength(2);
  });
  it('leave out what a world does not have', () => {
    const drawer = factsOf(sideOf(mms({ discovered: null, visited: null }), 1.25));
    for (const name of ['left, ahead, right', 'speed + search', 'speed run', 'cells visited', 'first lost step'])
      expect(drawer.has(name), name).toBe(false);
    expect(drawer.get('time')).toEqual(['1.3 of 2.0 s']);
    expect(drawer.get('best possible')).toEqual(['3.1']);
    expect(factsOf(sideOf(steps())).has('time')).toBe(false);
  });
  it('of a robot that drives are its times and speeds', () => {
    const facts = factsOf(sideOf(seconds(), 5.5));
    expect(facts.get('time in this run')).toEqual(['2.500 s']);
    expect(facts.get('since the gate')).toEqual(['1.500 s']);
    expect(facts.get('decisions')).toEqual(['2, 1 replanned']);
  });
});

describe('the list of steps', () => {
  const list = (play: Play, time: number, asked: unknown[][] = []) =>
    drawn(<Steps state={stateOf([sideOf(play, time)])} actions={actionsOf(asked)} />);
  it('marks the step of the moment and the first lost one, and leads to others', () => {
    const asked: unknown[][] = [];
    const room = list(steps(), 2, asked);
    expect(texts(room, 'tr[aria-current] th')).toEqual(['3']);
    expect(texts(room, 'tr.lost th')).toEqual(['4']);
    expect(texts(room, 'tr.lost td').at(-2)).toBe('1');
    all(room, 'tbody button')[5].click();
    expect(asked).toEqual([['seek', 5]]);
  });
  it('has the columns of its world', () => {
    const heads = (play: Play) => texts(list(play, 0), 'thead th');
    const place = ['at', 'heading'];
    const reading = ['left, ahead, right', 'does', 'loses', 'blocked'];
    expect(heads(steps())).toEqual(['step', 'run', ...place, ...reading]);
    expect(heads(mms())).toEqual(['step', 'seconds', ...place, 'does', 'blocked']);
    expect(heads(seconds())).toEqual(['step', 'run', 'seconds', ...place, 'does', 'takes, ms']);
  });
  it('says what the turns of a robot that drives are', () => {
    const turns = (play: Play) => texts(list(play, 0), '.meanings dt');
    expect(turns(seconds())).toContain('turn S90');
    expect(turns(steps())).toEqual([]);
  });
  it('has only the lines in view', () => {
    const many = Array.from({ length: 1000 }, (_, i) => i);
    const play = steps({
      ...{ clock: [...many, 1000], x: [...many, 0].map(() => 1), y: [...many, 0].map(() => 1) },
      ...{ heading: [...many, 0].map(() => 0), run: [...many, 0].map(() => 0), scores: [...many, 0] },
      ...{ action: many.map(() => '1'), blocked: many.map(() => false), entered: many.map(() => []) },
    });
    const lines = texts(list(play, 0), 'tbody th');
    expect(lines[0]).toBe('1');
    expect(lines.length).toBeLessThan(40);
    expect(all(list(play, 0), 'table')[0].getAttribute('aria-rowcount')).toBe('1002');
  });
});

describe('the controls of time', () => {
  const controls = (play: Play, asked: unknown[][] = []) =>
    drawn(<Transport state={stateOf([sideOf(play)])} actions={actionsOf(asked)} />);
  it('mark the runs and the first lost step on the scrubber', () => {
    const strip = (play: Play) =>
      all(controls(play), '.strip span').map(({ className, style }) => [className, style.left, style.width]);
    expect(strip(steps())).toEqual([
      ['to-goal', '0%', '37.5%'],
      ['onwards', '37.5%', '25%'],
      ['route', '62.5%', '37.5%'],
      ['loss', '37.5%', ''],
    ]);
    expect(strip(steps({ loses: [] })).map(([name]) => name)).not.toContain('loss');
    const drawer = mms({ goal_frame: 2, reset_frame: 3 });
    expect(strip(drawer).map(([name]) => name)).toEqual(['to-goal']);
    expect(prepare(drawer).resetFrame).toBe(-1);
    expect(strip(seconds()).map(([name]) => name)).toEqual(['to-goal', 'route']);
  });
  it('lead to the runs, under the names of the world', () => {
    const asked: unknown[][] = [];
    const room = controls(seconds(), asked);
    expect(texts(room, '.mark')).toEqual(['Search', 'Goal', 'Speed run']);
    all(room, '.mark').forEach((mark) => mark.click());
    expect(asked).toEqual([
      ['jump', 'start'],
      ['jump', 'goal'],
      ['jump', 'speed'],
    ]);
    expect(texts(controls(mms()), '.mark:not([disabled])')).toEqual([]);
  });
  it('say the moment to those who listen, but not while it runs', () => {
    const { room, draw } = drawing();
    const state = stateOf([sideOf(steps(), 2)], 2);
    const said = () => room.querySelector('input')!.getAttribute('aria-valuetext');
    draw(<Transport state={state} actions={nothing} />);
    expect(said()).toContain('after 2 of 8');
    const running = { ...stateOf([sideOf(steps(), 5)], 5), clock: { ...state.clock, time: 5, playing: true } };
    draw(<Transport state={running} actions={nothing} />);
    expect([said(), room.querySelector('input')!.value]).toEqual([expect.stringContaining('after 2 of 8'), '5']);
    expect(all(room, '[aria-label=Pause]')).toHaveLength(1);
  });
});

describe('the layers', () => {
  it('are toggled, and go back to what is usual', () => {
    const asked: unknown[][] = [];
    const state = stateOf([sideOf(steps())]);
    const { room, draw } = drawing();
    const again = () => draw(<Legend state={state} actions={actionsOf(asked)} />);
    const back = () => all(room, 'button')[0];
    again();
    expect(back().hidden).toBe(true);
    all(room, 'input')[0].click();
    expect(asked).toEqual([['setLayers', { wrong: true }]]);
    state.layers.wrong = true;
    again();
    expect(texts(room, '.layer.on label')).toContain(' Wrong guesses');
    expect(back().hidden).toBe(false);
    back().click();
    expect(asked[1]).toEqual(['setLayers', usualLayers]);
  });
  it('keep the focus when others change', () => {
    const state = stateOf([sideOf(steps())]);
    const { room, draw } = drawing();
    draw(<Legend state={state} actions={nothing} />);
    const box = all(room, 'input').at(-1)!;
    box.focus();
    state.layers.wrong = true;
    draw(<Legend state={state} actions={nothing} />);
    expect(document.activeElement).toBe(box);
  });
});

const candidate = (score: number, worth = true): Candidate => ({
  ...{ wall: [1, 2, 'north'], goal: false, seen_from: [1, 1], through: 3, travel: 1 },
  ...{ worth, score },
});
const choice = (frame: number, chosen: number, candidates: Candidate[]): Choice => ({
  ...{ frame, ground: '', candidates, chosen, known: 0, hope: 0, price: 0 },
});

describe('reasons', () => {
  const reasons = [
    choice(1, 2, [candidate(3), candidate(1, false), candidate(9), ...[4, 5, 6, 7].map((score) => candidate(score))]),
    choice(3, -1, []),
  ];
  it('are those of the last choice, the chosen wall first', async () => {
    const { room, draw } = drawing();
    const at = (time: number) =>
      draw(<Reasons state={stateOf([sideOf(steps({ reasons }), time)])} actions={nothing} />);
    at(0);
    expect(texts(room, '.choice')).toEqual(['No choice yet.']);
    at(2);
    const scores = () => texts(room, 'tbody td:last-child');
    expect(scores()).toEqual(['9.00', '3.00', '4.00', '5.00', '6.00', '7.00']);
    all(room, 'button')[0].click();
    await settled();
    expect(scores().at(-1)).toBe('1.00');
    at(5);
    expect(texts(room, '.note')[0]).toContain('No unseen wall is left');
    expect(texts(room, 'table')).toEqual([]);
  });
});

describe('what stands beside', () => {
  it('two mice that part, and where', () => {
    const asked: unknown[][] = [];
    const other = steps({
      mouse: 'other',
      action: ['1', 'left, 2', ...steps().action.slice(2)],
      x: [1, 1, 3, 5, 5, 1, 1, 5, 5],
    });
    const part = (...plays: Play[]) =>
      drawn(<PartingPoint state={stateOf(plays.map((play) => sideOf(play)))} actions={actionsOf(asked)} />);
    const room = part(steps(), other);
    expect(room.textContent).toContain('step 2, in cell (0,1)');
    all(room, 'button')[0].click();
    expect(asked).toEqual([['seek', 1]]);
    expect(part(steps(), steps()).textContent).toContain('same way');
    expect(part(steps(), mms()).textContent).toBe('');
  });
  it('the runs of a contest, the present one marked', () => {
    const asked: unknown[][] = [];
    const room = drawn(<Runs state={stateOf([sideOf(seconds(), 4)])} actions={actionsOf(asked)} />);
    expect(texts(room, 'tbody th')).toEqual(['1 search', '2 speed run']);
    expect(texts(room, 'tr[aria-current] th')).toEqual(['2 speed run']);
    all(room, 'tbody button')[1].click();
    expect(asked).toEqual([
      ['choose', 0],
      ['seek', 3],
    ]);
  });
  it('how each run ended, and where it crashed, which leads to that moment', () => {
    const asked: unknown[][] = [];
    const [search, fast] = seconds().drive!.runs;
    const crash = { time: 5.25e6, cell: [0, 1] as [number, number] };
    const runs = [
      { ...search, ended: 'done' },
      { ...fast, ended: 'slid', crash },
    ];
    const play = seconds({ drive: { ...seconds().drive!, runs } });
    const room = drawn(<Runs state={stateOf([sideOf(play)])} actions={actionsOf(asked)} />);
    expect(texts(room, 'thead th').at(-1)).toBe('ends');
    expect(texts(room, 'tbody td:last-child')).toEqual(['goal', '5.250 s, crash in (0,1): tyres slipped']);
    all(room, '.crash button')[0].click();
    expect(asked).toEqual([
      ['choose', 0],
      ['seek', 5.25],
    ]);
    const exact = drawn(<Runs state={stateOf([sideOf(seconds())])} actions={nothing} />);
    expect(texts(exact, 'thead th')).not.toContain('ends');
  });
  it('crashes in the list of steps, and in the words of the moment', () => {
    const play = seconds({ blocked: [false, true, false, false, false] });
    const list = drawn(<Steps state={stateOf([sideOf(play)])} actions={nothing} />);
    expect(texts(list, 'tbody td:nth-last-child(2)')).toEqual(['', 'a crash', '', '', '', '']);
    expect(momentText(sideOf(play, 1))).toContain('crashes');
    expect(momentText(sideOf(play, 0))).not.toContain('crashes');
  });
  it('what the times of runs are, with no claim about how they begin', () => {
    const room = drawn(<Runs state={stateOf([sideOf(seconds())])} actions={nothing} />);
    expect(texts(room, '.note').join()).not.toContain('rest');
  });
  it('last words as text', () => {
    const room = drawn(<LastWords state={stateOf([sideOf(steps({ last_words: '<b>bye</b>' }))])} actions={nothing} />);
    expect(texts(room, 'pre')).toEqual(['<b>bye</b>']);
    expect(all(room, 'b')).toEqual([]);
  });
  it('only the files that can be made', () => {
    const disabled = (play: Play, record = '{}') =>
      texts(drawn(<Files page={{} as Page} state={stateOf([{ ...sideOf(play), record }])} />), 'button:disabled');
    expect(disabled(steps())).toEqual([]);
    expect(disabled(mms())).toEqual(['Save whole walk (SVG)']);
    expect(disabled(steps(), '')).toEqual(['Save record', 'Save whole walk (SVG)']);
  });
  it('the score as it ticks', () => {
    const caption = (play: Play, time: number) => texts(drawn(<Caption {...sideOf(play, time)} />), '.ticker span');
    expect(caption(steps(), 4)).toEqual(['0.133', 'score so far', 'best possible 3.133', '4 of 8 steps, search']);
    expect(caption(mms(), 2).slice(2)).toEqual(['best possible 3.1', '4 of 4 steps, ended']);
    expect(caption(seconds(), 4)).toEqual([
      ...['4.000', 's on the clock', 'no run so far', 'best possible 1.250', '3 of 5 moves, speed run'],
    ]);
  });
});
