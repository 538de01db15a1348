// @vitest-environment happy-dom
// What is wrong with a field is in sight.
import { render } from 'preact';
import { beforeEach, expect, it } from 'vitest';
import { Field } from '../../src/ui/field';

let scrolled: Element[] = [];
let room: HTMLElement;
beforeEach(() => {
  scrolled = [];
  document.body.replaceChildren((room = document.createElement('main')));
  Element.prototype.scrollIntoView = function (this: Element) {
    scrolled.push(this);
  };
});

function two() {
  const complain = (error: string) =>
    render(
      <>
        <Field label="Width" error={error}>
          <input />
        </Field>
        <input class="other" />
      </>,
      room,
    );
  complain('');
  const found = (selector: string) => room.querySelector<HTMLElement>(selector)!;
  return { complain, row: found('.field'), control: found('.field input'), other: found('.other') };
}

it('an error is brought into sight once, with the role of an alert', () => {
  const { complain, row, control } = two();
  complain('too wide');
  complain('too wide');
  complain('');
  expect(scrolled).toEqual([row]);
  expect(row.querySelector('[role=alert]')!.id).toBe(control.getAttribute('aria-describedby'));
});

it('an error elsewhere takes nobody away from where they write', () => {
  const { complain, other } = two();
  other.focus();
  complain('too wide');
  expect(scrolled).toEqual([]);
});
