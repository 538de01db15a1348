// In which world a mouse runs: in steps, or in seconds with a robot and rules.
import type { About } from '../core/types';
import { h } from '../ui/dom';
import { isMine, myRobot, nameOf, onMyRobot, setMyRobot } from '../robot/mine';
import { field } from '../ui/field';

export interface WorldChoice {
  element: HTMLElement;
  /** The robot and the rules of a contest in seconds; null in steps. */
  drive(): { robot: string; rules: string } | null;
  /** In seconds with those, or in steps where there is no robot. A name that is none stays as it was. */
  choose(robot?: string, rules?: string): void;
}

export function createWorldChoice({ mice, robots, drive_rules }: About, changed: () => void): WorldChoice {
  const select = (options: [string, string][]) =>
    h(
      'select',
      { onchange: () => (update(), changed()) },
      ...options.map(([value, text]) => h('option', { value }, text)),
    );
  const world = select([
    ['steps', 'steps, as in the capstone project'],
    ['seconds', 'seconds: curves and diagonals'],
  ]);
  const robot = select(robots.map(({ name, cell }) => [name, `${name}, cells of ${cell} mm`]));
  const rules = select(drive_rules.map(({ name }) => [name, name]));
  const source = h('span', {});
  const drivers = mice.filter(({ drives }) => drives).map(({ name }) => name);
  const worldNote = h('span', {});
  /** That of the view Robot, where there is one. */
  const own = h('option', { hidden: true });
  robot.append(own);
  const robotRow = field('Robot', robot, h('a', { href: '#robot' }, 'Change its numbers'));
  const rulesRow = field('Rules', rules, source);

  function update() {
    const seconds = world.value === 'seconds';
    robotRow.hidden = rulesRow.hidden = !seconds;
    worldNote.textContent = seconds ? `mice that can drive: ${drivers.join(', ')}` : '';
    source.textContent = drive_rules.find(({ name }) => name === rules.value)?.source ?? '';
  }
  function offerMine() {
    const mine = myRobot();
    const chosen = robot.value === own.value && !own.hidden;
    if (mine === null && chosen) robot.value = robots[0].name;
    own.hidden = mine === null;
    own.disabled = mine === null;
    own.value = mine ?? '';
    own.textContent = mine === null ? '' : `${nameOf(mine)}, my robot`;
    if (mine !== null && chosen) robot.value = mine;
    if (chosen && world.value === 'seconds') changed();
  }
  onMyRobot(offerMine);
  offerMine();
  const set = (of: HTMLSelectElement, value: string | undefined) => {
    if (value !== undefined && [...of.options].some((option) => option.value === value)) of.value = value;
  };
  update();
  return {
    element: h(
      'div',
      { hidden: robots.length === 0 || drive_rules.length === 0 },
      field('World', world, worldNote),
      robotRow,
      rulesRow,
    ),
    drive: () => (world.value === 'seconds' ? { robot: robot.value, rules: rules.value } : null),
    choose(wantedRobot, wantedRules) {
      world.value = wantedRobot === undefined ? 'steps' : 'seconds';
      if (wantedRobot !== undefined && isMine(wantedRobot)) setMyRobot(wantedRobot);
      set(robot, wantedRobot);
      set(rules, wantedRules);
      update();
    },
  };
}
