// What the robot begins from, what it is called, and where it goes.
import type { ComponentChildren } from 'preact';
import { nameOf, type Origin } from '../link/my-robot';
import type { Page } from '../page/page';
import { Button, Select } from '../ui/controls';
import { Field } from '../ui/field';
import type { Draft } from './draft';

interface Props {
  page: Page;
  draft: Draft;
  /** What is wrong with it. */
  error: string;
  /** Stands below. */
  children: ComponentChildren;
  /** Hears of another robot to begin from. */
  begin(from: Origin): void;
  rename(name: string): void;
}

/** Whether there is a robot to save and to use, `draft.refused` says. */
export function StartCard({ page, draft, error, children, begin, rename }: Props) {
  const { origin, name, refused, text } = draft;
  function use(view: 'live' | 'race') {
    location.hash = view;
    page.tell(`${name} can be chosen under Robot, in worlds in which robots drive.`);
  }
  const uses: [string, () => void][] = [
    ['Save as TOML', () => page.save(`${nameOf(name) || 'robot'}.toml`, text, 'application/toml')],
    ['Drive it in Live', () => use('live')],
    ['Race with it', () => use('race')],
  ];
  const built = page.about.robots.map(({ name, cell }) => [name, `${name}, cells of ${cell} mm`]);
  const opened: [string, string][] = origin.text === null ? [] : [['', origin.name]];
  return (
    <section class="card" aria-label="Start from">
      <h2>My robot</h2>
      <Field label="Start from" help="the robot that all changes are compared with">
        <Select
          options={[...built, ...opened]}
          value={origin.text === null ? origin.name : ''}
          choose={(name) => begin({ name, text: null })}
        />
      </Field>
      <Field label="Name" error={error}>
        <input
          type="text"
          spellcheck={false}
          value={name}
          onInput={({ currentTarget }) => rename(currentTarget.value)}
        />
      </Field>
      <div class="row">
        <Button label="Undo all changes" act={() => begin({ ...origin })} />
        <Button label="Open a TOML file" act={page.choose} />
      </div>
      <div class="row">
        {uses.map(([label, act]) => (
          <Button label={label} disabled={refused} act={act} />
        ))}
      </div>
      {children}
    </section>
  );
}
