// @vitest-environment happy-dom
// The card of a real robot in Live, as the tree that it is.
import { render } from 'preact';
import { expect, it, vi } from 'vitest';
import type { LiveFinding, LiveState } from '../../src/core/types';
import { createRobotPart, RobotCard } from '../../src/live/robot-card';
import type { Page } from '../../src/page/page';

const finding: LiveFinding = { kind: 'false_wall', line: 2, cell: [0, 0], side: 'east', words: 'line 2: false wall' };
const state: LiveState = {
  ...{ stream: 1, unseen: [3, 1, 2, 0], drawing: '', fields: {}, values: [], findings: [], contradictions: [] },
  ...{ wrong: [], advice: '', plan: '', lines: 0, noise: 0, restarts: 0, pose: null, route: [] },
  maze: { name: '', width: 2, height: 2, walls: [9, 3, 12, 6], start: [0, 0], heading: 'north', goals: [[1, 1]] },
};

/** The core after a line; hears what it is asked. */
function pageOf(asked: string[]) {
  const call = async (name: string) => {
    asked.push(name);
    if (name !== 'live_feed') return state;
    const pose = { cell: [0, 1], heading: 'north' };
    return { ...state, lines: 3, noise: 1, pose, wrong: [finding], findings: [finding], advice: 'the known route' };
  };
  return { core: { call }, about: { robots: [{ name: 'classic' }] } } as unknown as Page;
}

/** Counts what is painted; happy-dom paints nothing. */
function paintedOn() {
  const calls: string[] = [];
  const context = new Proxy({} as Record<string, unknown>, {
    get: (own, name: string) => own[name] ?? (() => void calls.push(name)),
  });
  HTMLCanvasElement.prototype.getContext = (() => context) as never;
  return calls;
}

it('shows what the lines say', async () => {
  const painted = paintedOn();
  const asked: string[] = [];
  const room = document.createElement('div');
  document.body.append(room);
  const draw = () => render(<RobotCard part={part} maze={null} />, room);
  const part = createRobotPart(pageOf(asked), draw);
  draw();
  const select = room.querySelector('select')!;
  select.value = 'text';
  select.dispatchEvent(new Event('change', { bubbles: true }));
  await vi.waitFor(() => expect(room.querySelector('textarea')!.closest('.field')!.hasAttribute('hidden')).toBe(false));
  const area = room.querySelector('textarea')!;
  area.value = '0 0 N 101\n';
  area.dispatchEvent(new Event('input', { bubbles: true }));
  await vi.waitFor(() => expect(room.querySelector('button')!.textContent).toBe('Read'));
  room.querySelector('button')!.click();
  await vi.waitFor(() => expect(room.querySelector('li')?.textContent).toBe(finding.words));
  expect(asked).toEqual(['live_begin', 'live_feed']);
  expect(room.textContent).toContain('the known route.');
  expect(room.querySelector<HTMLInputElement>('[type=range]')!.max).toBe('3');
  expect(room.querySelector('canvas')!.getAttribute('aria-label')).toContain('(0,1) north');
  // The robot is turned to its heading, and painted.
  await vi.waitFor(() => expect(painted).toContain('rotate'));
});

it('connects by itself where labmouse live serves the page', async () => {
  paintedOn();
  const mark = document.createElement('meta');
  mark.name = 'labmouse-robot';
  document.head.append(mark);
  vi.stubGlobal('fetch', async (name: string) => ({
    ok: true,
    json: async () => ({ width: 2, height: 2, robot: 'classic' }),
    body: new Response(name === 'lines' ? '0 0 N 101\n' : '').body,
  }));
  const asked: string[] = [];
  const room = document.createElement('div');
  document.body.append(room);
  const draw = () => render(<RobotCard part={part} maze={null} />, room);
  const part = createRobotPart(pageOf(asked), draw);
  draw();
  await vi.waitFor(() => expect(room.textContent).toContain('3 lines'));
  expect(asked).toContain('live_feed');
  expect(part.robot.state.wanted).toMatchObject({ source: 'served', robot: 'classic', width: 2, height: 2 });
  mark.remove();
  vi.unstubAllGlobals();
});
