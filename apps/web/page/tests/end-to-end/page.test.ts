import { expect, test } from 'vitest';
import { barriers, open, provoked } from './harness';

test('it opens from the disk, names its views, and asks nothing of a network', async () => {
  const page = await open();
  const views = await page.getByRole('navigation', { name: 'Views' }).getByRole('link').allTextContents();
  expect(views).toEqual(['Race', 'Replay', 'Live', 'Draw', 'Write', 'Robot']);
  expect(await barriers(page)).toEqual([]);
});

test('its policy lets no script in that is not its own, and nothing out', async () => {
  const page = await open('#draw');
  const policy = await page.locator('meta[http-equiv="Content-Security-Policy"]').getAttribute('content');
  expect(policy).toContain("default-src 'none'");
  const blocked = await page.evaluate(async () => {
    const directives: string[] = [];
    const next = () =>
      new Promise((done) => {
        const note = (event: Event) =>
          done(directives.push((event as SecurityPolicyViolationEvent).effectiveDirective));
        addEventListener('securitypolicyviolation', note, { once: true });
      });
    const inAttribute = next();
    document.body.insertAdjacentHTML('beforeend', '<button onclick="window.intruder = 1">x</button>');
    document.querySelector<HTMLElement>('body > button')!.click();
    await inAttribute;
    const inElement = next();
    document.body.append(Object.assign(document.createElement('script'), { textContent: 'window.intruder = 2' }));
    await inElement;
    const outside = next();
    void fetch('http://localhost:1/').catch(() => null);
    await outside;
    return [...directives, (window as unknown as { intruder?: number }).intruder ?? 'no intruder'];
  });
  expect(blocked).toEqual(['script-src-attr', 'script-src-elem', 'connect-src', 'no intruder']);
  expect(provoked(/Content Security Policy/)).toBeGreaterThanOrEqual(3);
});
