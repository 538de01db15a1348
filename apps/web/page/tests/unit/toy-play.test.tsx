// @vitest-environment happy-dom
// A world that the page has never heard of: it is chosen and raced, and what a report of one contest carries is played.
import { existsSync, readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { render, type VNode } from 'preact';
import { beforeAll, describe, expect, it } from 'vitest';
import type { Core } from '../../src/core/client';
import { startModule } from '../../src/core/module';
import type { About, PackedRecord, Play, RaceGroup, RaceResults, WorldInPage } from '../../src/core/types';
import { contestBehind } from '../../src/link/contest';
import { createWorldChoice } from '../../src/choice/world-choice';
import { Facts } from '../../src/player/facts';
import { has, layerNames } from '../../src/player/layers';
import { timeText } from '../../src/player/sheet';
import { Steps } from '../../src/player/steps';
import { Transport } from '../../src/player/transport';
import { momentText } from '../../src/player/words';
import { contestPlay } from '../../src/race/contest-play';
import { boardsOf } from '../../src/results/contests';
import { addressOf, readAddress } from '../../src/link/address';
import { orderIn, orderMoment } from '../../src/race/linked-order';
import { loadedRace } from '../../src/results/loaded';
import type { EarlyPage } from '../../src/page/page';
import { seconds, steps } from './plays';
import { actionsOf, sideOf, stateOf } from './sides';

const root = resolve(__dirname, '../../../../..');
const wasm = process.env.LABMOUSE_CORE ?? `${root}/build/web/labmouse_core.wasm`;
/** Its native test keeps it true. */
const report = JSON.parse(readFileSync(`${root}/tests/toy/report.json`, 'utf8')) as {
  groups: RaceGroup[];
  records: PackedRecord[];
  record: unknown[];
};
const [group] = report.groups;
const [result] = group.mice[0].results;

const nothing = actionsOf([]);
function drawn(tree: VNode): HTMLElement {
  const room = document.createElement('div');
  render(tree, room);
  return room;
}
const texts = (room: HTMLElement, selector: string) =>
  [...room.querySelectorAll(selector)].map(({ textContent }) => textContent);
const factsOf = (play: Play, time: number) => {
  const rows = drawn(<Facts state={stateOf([sideOf(play, time)])} actions={nothing} />).querySelectorAll('tbody tr');
  return new Map([...rows].map((row) => [row.children[0].textContent, row.children[1].textContent]));
};

describe.skipIf(!existsSync(wasm))('a contest of a world that nobody has told the page of', () => {
  let core: Core;
  let about: About;
  beforeAll(async () => {
    const call = await startModule(await WebAssembly.compile(readFileSync(wasm)));
    core = {
      async call(name: never, request: never, bytes?: Uint8Array) {
        const { answer, failure } = call(name, request, bytes);
        if (failure) throw new Error(failure.error);
        return answer;
      },
    } as unknown as Core;
    about = await core.call('about', {});
  });

  /** As a page does that was opened with the report. */
  async function reported() {
    const page = { core, ready: Promise.resolve(about), complain: expect.unreachable } as unknown as EarlyPage;
    const results = { groups: report.groups } as unknown as RaceResults;
    const sources = { core, ready: page.ready, links: new Map(), opened: new Map() };
    const race = loadedRace(results, { ...sources, records: async () => report.records });
    return contestPlay(page, race, boardsOf(results)[0], { mouse: 0, maze: 0, position: 0 });
  }

  it('is played from the report, with the score of its results', async () => {
    const { play, remark } = await reported();
    expect([play.world, play.score, remark]).toEqual(['toy', result.score, '']);
    const last = play.clock.length - 1;
    const facts = factsOf(play, last);
    expect(facts.get('score so far')).toBe((result.score as number).toFixed(3));
    expect(facts.get('steps')).toBe(`${last} of ${last}`);
    expect(layerNames.filter((layer) => has(play, layer))).toContain('speed');
    const bar = drawn(<Transport state={stateOf([sideOf(play)])} actions={nothing} />);
    expect(texts(bar, '.mark:not([disabled])')).toEqual(['Search', 'Goal', 'Speed run']);
    expect(texts(bar, '.rate')).toEqual(['4 steps/s']);
  });
  it('is the same from the file of its record', async () => {
    const { play } = await reported();
    const text = report.record.map((line) => JSON.stringify(line)).join('\n');
    const opened = await core.call('open', { name: 'toy.jsonl' }, new TextEncoder().encode(text));
    if (opened.kind !== 'record') return expect.unreachable();
    expect({ ...opened.play, checked: '' }).toEqual({ ...play, checked: '' });
  });
  it('loses in its steps what its score has above the best possible one', async () => {
    const { play } = await reported();
    const lost = (run: number) => play.loses.reduce((sum, loss, i) => sum + (play.run[i] === run ? loss : 0), 0);
    expect(lost(1) + lost(0) / 30).toBeCloseTo(play.score! - play.bound!, 9);
  });
  it('has no link, and nobody stands beside it, for the page cannot hold it', async () => {
    const { play } = await reported();
    expect(play.again).toBeUndefined();
    await expect(contestBehind(core, play, about)).rejects.toThrow('cannot hold');
  });
  it('is ordered by what the core says of its world', async () => {
    const toy: WorldInPage = {
      ...{ name: 'toy', summary: 'mice that stumble', in_steps: false, plays: true, is_stochastic: true, usual_runs: 3, mice: ['flood'] },
      settings: [
        { name: 'clumsiness', type: 'whole', default: '50', meaning: 'How often', low: 0, high: 100 },
        { name: 'asleep', type: 'flag', default: 'false', meaning: 'Whether it sleeps' },
        { name: 'shoes', type: 'choice', default: 'none', meaning: 'What it wears', choices: ['none', 'clogs'] },
      ],
    };
    const world = createWorldChoice({ ...about, worlds: [...about.worlds, toy] }, () => undefined);
    expect(world.chosen()).toMatchObject({ world: about.worlds[0], settings: {} });
    world.choose('toy', { shoes: 'clogs', clumsiness: 7 });
    expect(world.chosen()).toEqual({ world: toy, settings: { clumsiness: 7, asleep: false, shoes: 'clogs' } });
    expect(world.drive()).toBeNull();
    const order = { mice: ['flood'], mazes: ['contest-01'], runs: 1, seed: 1 };
    const raced = { ...world.chosen().settings, world: 'toy' };
    await expect(orderMoment(core, about, { ...order, world: raced })).rejects.toThrow('world toy');
    // A link holds what is not the usual of any world that the core has.
    const known = { ...about, worlds: [...about.worlds, toy] };
    for (const set of [
      { shoes: 'clogs', clumsiness: 7, asleep: false },
      { shoes: 'none', clumsiness: 50, asleep: true },
    ]) {
      const asked = { ...order, world: { ...set, world: 'toy' } };
      const hash = `#${addressOf('race', await orderMoment(core, known, asked))}`;
      expect(hash.includes('set=shoes')).toBe(set.shoes !== 'none');
      expect(await orderIn(core, known, readAddress(hash).moment)).toEqual(asked);
    }
    const linked = (text: string) =>
      orderIn(core, known, readAddress(`#race&mouse=flood&in=contest-01&${text}`).moment);
    const [home] = about.worlds;
    for (const wrong of [
      ...[
        'world=mars',
        `world=${home.name}&set=${home.settings[0].name}=5`,
        'set=asleep=true',
        'world=toy&robot=classic',
      ],
      ...['shoes=boots', 'height=3', 'clumsiness=much', 'clumsiness=', 'asleep=maybe', 'asleep'].map(
        (text) => `world=toy&set=${text}`,
      ),
    ])
      await expect(linked(wrong), wrong).rejects.toThrow('cannot be followed');
    world.choose('seconds', { robot: about.robots[1].name });
    expect(world.drive()?.robot).toBe(about.robots[1].name);
  });
});

describe('a world whose clock counts seconds, with one kind of run', () => {
  const play = steps({
    world: 'moon',
    rules: null,
    traits: { ...seconds().traits, unit: 'craters', digits: 2, bound: 'a walk', runs: ['walk'] },
    clock: [0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4],
    run: Array(9).fill(0),
    left: [],
    loses: [],
  });
  const side = sideOf(play, 2);
  it('is told in its own words', () => {
    expect(momentText(side)).toContain('walk: at (2,1) south');
    expect(timeText(side.track, 2)).toBe('2.00 s');
    const facts = factsOf(play, 2);
    expect(facts.get('time')).toBe('2.0 of 4.0 s');
    expect(facts.get('best possible')).toBe('3.13 craters');
    expect(facts.has('speed run')).toBe(false);
  });
  it('has a list and marks of that', () => {
    const state = stateOf([side]);
    expect(texts(drawn(<Steps state={state} actions={nothing} />), 'thead th')).toEqual([
      ...['step', 'seconds', 'at', 'heading', 'does', 'blocked'],
    ]);
    expect(texts(drawn(<Transport state={state} actions={nothing} />), '.mark')).toEqual(['Goal']);
    expect(layerNames.filter((layer) => has(play, layer))).toEqual([
      ...['walls', 'wrong', 'visits', 'distances', 'search', 'best'],
    ]);
  });
});
