// What the robot begins from, what it is called, and where it goes.
import { nameOf, type Origin } from '../link/my-robot';
import type { Page } from '../page/page';
import { button, select } from '../ui/controls';
import { h } from '../ui/dom';
import { complainAt, field } from '../ui/field';
import type { Draft } from './draft';

export type StartCard = ReturnType<typeof createStartCard>;

/** `parts` stand below; `begin` hears of another robot to begin from, `renamed` of another name. */
export function createStartCard(
  page: Page,
  draft: Draft,
  parts: HTMLElement[],
  begin: (from: Origin) => void,
  renamed: () => void,
) {
  const choice = select(
    page.about.robots.map(({ name, cell }) => [name, `${name}, cells of ${cell} mm`]),
    (name) => begin({ name, text: null }),
  );
  const opened = h('option', { value: '', hidden: true }, 'a file');
  choice.append(opened);
  choice.value = draft.origin.name;
  const name = h('input', { type: 'text', value: 'my-mouse', spellcheck: 'false', oninput: renamed });
  const row = field('Name', name);
  const save = () => page.save(`${nameOf(name.value) || 'robot'}.toml`, draft.text, 'application/toml');
  function use(view: 'live' | 'race') {
    location.hash = view;
    page.tell(`${name.value} can be chosen under Robot, in worlds in which robots drive.`);
  }
  const uses = [
    button('Save as TOML', save),
    button('Drive it in Live', () => use('live')),
    button('Race with it', () => use('race')),
  ];
  return {
    element: h(
      'section.card',
      { 'aria-label': 'Start from' },
      h('h2', 'My robot'),
      field('Start from', choice, h('span', 'the robot that all changes are compared with')),
      row,
      h(
        'div.row',
        button('Undo all changes', () => begin({ ...draft.origin })),
        button('Open a TOML file', page.choose),
      ),
      h('div.row', ...uses),
      ...parts,
    ),
    name,
    /** In one line. */
    called: () => name.value.trim().replaceAll('\n', ' ') || 'robot',
    /** What it begins from. */
    show(origin: Origin) {
      opened.hidden = origin.text === null;
      opened.textContent = origin.name;
      choice.value = origin.text === null ? origin.name : '';
      if (origin.text !== null) name.value = origin.name;
    },
    complain: (message: string) => complainAt({ name: row }, 'name', message),
    /** Whether there is a robot to save and to use. */
    enable: (is: boolean) => uses.forEach((one) => (one.disabled = !is)),
  };
}
