// @vitest-environment happy-dom
// What is wrong with a field is in sight.
import { beforeEach, expect, it } from 'vitest';
import { h } from '../../src/ui/dom';
import { field } from '../../src/ui/field';

let scrolled: Element[] = [];
beforeEach(() => {
  scrolled = [];
  document.body.replaceChildren();
  Element.prototype.scrollIntoView = function (this: Element) {
    scrolled.push(this);
  };
});

function two() {
  const [control, other] = [h('input'), h('input')];
  const row = field('Width', control);
  document.body.append(row, other);
  return { row, control, other };
}

it('an error is brought into sight once, with the role of an alert', () => {
  const { row, control } = two();
  row.complain('too wide');
  row.complain('too wide');
  row.complain('');
  expect(scrolled).toEqual([row]);
  expect(row.querySelector('[role=alert]')!.id).toBe(control.getAttribute('aria-describedby'));
});

it('an error elsewhere takes nobody away from where they write', () => {
  const { row, other } = two();
  other.focus();
  row.complain('too wide');
  expect(scrolled).toEqual([]);
});
