// The robot that the browser kept, when the page is opened again.
import { expect, it, vi } from 'vitest';
import { reopenRobot, type RobotDesk } from '../../src/robot/addresses';
import type { Origin } from '../../src/link/my-robot';

const classic = { name: 'classic', text: null };
const kept = { name: 'mine', text: 'cell = 180', origin: classic };

/** A desk whose core answers once `answer` is called. */
function waitingDesk() {
  let answer = () => {};
  const draft = { origin: null as Origin | null, fresh: true, name: '' };
  const show = vi.fn();
  const desk = {
    draft,
    form: { show },
    begin: (origin: Origin) => Object.assign(draft, { origin, fresh: true }),
    ask: () => {},
    page: {
      core: { call: () => new Promise((resolve) => (answer = () => resolve({ values: { cell: 180 }, keys: [] }))) },
    },
  };
  const reopened = reopenRobot(desk as unknown as RobotDesk, kept);
  return { desk, show, answered: () => (answer(), reopened) };
}

it('stands in the form again', async () => {
  const { desk, show, answered } = waitingDesk();
  await answered();
  expect(show).toHaveBeenCalledWith({ cell: 180 }, []);
  expect(desk.draft).toMatchObject({ origin: classic, fresh: false, name: 'mine' });
});

it('does not take the place of a robot that somebody began meanwhile, or edited', async () => {
  for (const act of [
    (desk: ReturnType<typeof waitingDesk>['desk']) => void desk.begin({ ...classic }),
    (desk: ReturnType<typeof waitingDesk>['desk']) => void (desk.draft.fresh = false),
  ]) {
    const { desk, show, answered } = waitingDesk();
    act(desk);
    await answered();
    expect(show).not.toHaveBeenCalled();
  }
});
